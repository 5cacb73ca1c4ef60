/** Several faces for each. All of it comes when there are faces. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['model'],
      isNeeded: ({ model }) => Boolean(model?.faces),
      load: (app) => import('./refine-entry.js').then((it) => it.offerRefining(app)),
    },
  ],
};
