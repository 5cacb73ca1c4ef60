/**
 * The features of the page. Each registers itself with a `feature.js` in its folder, so none is
 * named here.
 */

/** @type {Record<string, import("./context.js").Feature>} */
const FEATURES = import.meta.glob(['../features/*/feature.js', '../panels/*/feature.js'], {
  eager: true,
  import: 'default',
});

/**
 * The commands of the features; the errors of their actions are reported.
 * @param {import("./context.js").AppContext} app
 */
export const featureCommands = (app) =>
  Object.values(FEATURES)
    .flatMap(({ commands }) => commands?.(app) ?? [])
    .map((one) => ({ ...one, action: () => app.actions.reportErrors(one.action()) }));

/**
 * Loads a part when it is first needed, and after a failure when it is needed anew.
 * @param {import("./context.js").AppContext} app
 * @param {import("./context.js").Part} part
 */
export function loadWhenNeeded(app, { keys, isNeeded, load }) {
  let isLoaded = false;
  let wasNeeded = false;
  const loadIt = async () => {
    isLoaded = true;
    try {
      await load(app);
    } catch (error) {
      isLoaded = false;
      throw error;
    }
  };
  app.store.subscribe(keys, (state) => {
    const begins = !wasNeeded && isNeeded(state);
    wasNeeded = isNeeded(state);
    if (begins && !isLoaded) app.actions.reportErrors(loadIt());
  });
}

/** @param {import("./context.js").AppContext} app */
export function loadFeatures(app) {
  for (const { parts = [] } of Object.values(FEATURES))
    parts.forEach((part) => loadWhenNeeded(app, part));
}
