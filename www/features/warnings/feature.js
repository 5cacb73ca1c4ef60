/** Messages about a shape: the verdict on a run, and vertices that no constraint moves. */

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
