/** What one shape of all panels would do to the mesh, in words of the second worker. */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { newestOnly } from './latest-only.ts';
import { useApp } from './use-app.ts';
import type { ForecastWords } from '../pkg/engine/shape_up.js';

/**
 * Asks once for each model and unit, in which the words have lengths.
 * @param isWanted whether it is shown
 * @returns null if there is no forecast, undefined until it is known
 */
export function useForecastWords(isWanted: boolean): ForecastWords | null | undefined {
  const { store, actions } = useApp();
  const { model, document } = store.state;
  const units = document?.units;
  const newest = useMemo(() => newestOnly(() => store.get().model), [store]);
  const [known, setKnown] = useState<{
    model: unknown;
    units: string;
    found?: ForecastWords | null;
  } | null>(null);
  const isKnown = known !== null && known.model === model && known.units === units;
  useEffect(() => {
    if (!isWanted || isKnown || units === undefined) return;
    setKnown({ model, units });
    void newest(actions.trials.forecast().catch(() => null)).then((found) => {
      if (found !== undefined) setKnown({ model, units, found });
    });
  }, [isWanted, model, units]);
  return isKnown ? known.found : undefined;
}
