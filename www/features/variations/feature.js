/** Variations: other shapes that are equally exact. Loaded on first use. */

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
