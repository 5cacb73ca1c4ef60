/** The mesh itself: refined, or changed by an operation. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./refine-buttons.js').then((it) => it.addButtons(app)),
    },
  ],
};
