/** One press for all panels of a mesh that was opened. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./card.js').then((it) => new it.MakePanels(app)),
    },
  ],
};
