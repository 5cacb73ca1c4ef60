/** The experiment that some examples have. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['example'],
      isNeeded: ({ example }) => Boolean(example?.experiment),
      load: (app) => import('./offer.js').then((it) => it.offerExperiment(app)),
    },
  ],
};
