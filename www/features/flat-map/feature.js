/** The flat map beside the model. Loaded on first use. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'parametrize',
      group: 'View',
      label: 'Flatten: a flat map beside the model',
      keys: ['U'],
      action: () =>
        import('./flat-map-controller.js').then((it) => it.FlatMapController.of(app).toggle()),
      needsModel: true,
      enabled: ({ model }) => Boolean(model?.faces),
      pressed: ({ flatMap }) => flatMap !== null,
    },
  ],
};
