/**
 * The features of the page. Each registers itself with a `feature.ts` in its folder, so none is
 * named here.
 */

import { oneAtATime } from '../ui/once.ts';
import type { AppContext, Feature, Part } from './context.ts';

const FEATURES: Record<string, Feature> = import.meta.glob(
  ['../features/*/feature.ts', '../panels/*/feature.ts'],
  {
    eager: true,
    import: 'default',
  },
);

/**
 * The commands of the features. Errors of their actions are reported; a second press while one loads
 * and opens something has no effect.
 */
export const featureCommands = (app: AppContext) =>
  Object.values(FEATURES)
    .flatMap(({ commands }) => commands?.(app) ?? [])
    .map((one) => {
      const begin = oneAtATime(one.action);
      return { ...one, action: () => app.actions.reportErrors(begin()) };
    });

/** Loads a part when it is first needed, and after a failure when it is needed anew. */
export function loadWhenNeeded(app: AppContext, { keys, isNeeded, load }: Part) {
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
    if (begins && !isLoaded) void app.actions.reportErrors(loadIt());
  });
}

export function loadFeatures(app: AppContext) {
  for (const { parts = [] } of Object.values(FEATURES))
    parts.forEach((part) => loadWhenNeeded(app, part));
}
