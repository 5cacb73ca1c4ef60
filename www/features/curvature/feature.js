/** Curvature: principal directions and lines of curvature on the surface, and colours. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'curvature',
      group: 'View',
      label: 'Curvature',
      keys: [],
      action: () => import('./curvature-card.js').then((it) => it.toggle(app)),
      needsModel: true,
      enabled: ({ model, renderer }) => Boolean(model?.faces) && renderer !== 'none',
    },
  ],
};
