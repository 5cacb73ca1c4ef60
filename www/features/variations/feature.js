/** Other shapes that are as exact. All of it comes when it is first asked for. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document }) =>
        document?.constraints.some(({ require }) => require !== 'soft') === true,
      load: (app) => import('./entry.js').then((it) => it.offerVariations(app)),
    },
  ],
};
