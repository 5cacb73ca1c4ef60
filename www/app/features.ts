/**
 * The features of the page. Each registers itself with a `feature.ts` in its folder, so none is
 * named here.
 */

import { inTurn, oneAtATime } from '../ui/once.ts';
import type { AppContext, Feature, Part } from './context.ts';

const FEATURES: Record<string, Feature> = import.meta.glob(
  ['../features/*/feature.ts', '../panels/*/feature.ts'],
  {
    eager: true,
    import: 'default',
  },
);

/**
 * The commands of the features. Errors of their actions are reported. A second press while one loads
 * something has no effect, or closes it again if the command is a toggle.
 */
export const featureCommands = (app: AppContext) =>
  Object.values(FEATURES)
    .flatMap(({ commands }) => commands?.(app) ?? [])
    .map((one) => {
      const begin = one.pressed ? inTurn(one.action) : oneAtATime(one.action);
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
