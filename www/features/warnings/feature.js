/** What is worth saying of a shape: how a run ended, and vertices that nothing acts on. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./warnings.js').then((it) => it.watchConditions(app)),
    },
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.constraints.some(({ paired }) => paired)),
      load: (app) => import('./unpaired.js').then((it) => it.watchUnpaired(app)),
    },
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.free && document.constraints.length > 0),
      load: (app) => import('./free-vertices.js').then((it) => it.watchFreeVertices(app)),
    },
  ],
};
