/** The flat map beside the model. How it is made, and its panel, come when it is first asked for. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'parametrize',
      group: 'View',
      label: 'Flatten: a flat map beside the model',
      keys: ['U'],
      action: () =>
        app.actions.reportErrors(
          import('./uv-controller.js').then((it) => it.Parametrize.of(app).toggle()),
        ),
      needsModel: true,
      enabled: ({ model }) => Boolean(model?.faces),
      pressed: ({ flatMap }) => flatMap !== null,
    },
  ],
};
