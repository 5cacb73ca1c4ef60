/** Other shapes that are as exact. All of it comes when it is first asked for. */

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['numbers'],
      isNeeded: ({ numbers }) => Boolean(numbers?.exact),
      load: (app) => import('./entry.js').then((it) => it.offerVariations(app)),
    },
  ],
};
