/** How far the mesh will move for one shape of all panels, and what would reduce that. */

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { newestOnly } from '../../store/latest-only.ts';
import { isMeshLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import type { ForecastWords, MeshSuggestion } from '../../pkg/engine/shape_up.js';

export interface Forecast {
  /** null if there is none, undefined until it is known */
  found: ForecastWords | null | undefined;
  /** whether panels along the lines of curvature would help */
  newPanelsHelp: boolean;
  /** a simple change of the mesh that would reduce the move, unless new panels are the better choice */
  suggestion: MeshSuggestion | null;
}

/** @param isWanted whether it is shown; it is requested once for each model */
export function useForecast(isWanted: boolean): Forecast {
  const { store, actions } = useApp();
  const { model, document } = store.state;
  const [known, setKnown] = useState<{ model: unknown; found: ForecastWords | null } | null>(null);
  const newest = useMemo(() => newestOnly(() => store.get().model), [store]);
  const asked = useRef<unknown>(null);
  useEffect(() => {
    if (!isWanted || asked.current === model) return;
    asked.current = model;
    void newest(actions.trials.forecast().catch(() => null)).then((found) => {
      if (found !== undefined) setKnown({ model, found });
    });
  }, [isWanted, model]);
  const found = known?.model === model ? known?.found : undefined;
  const isLocked = isMeshLocked({ document });
  const newPanelsHelp = !isLocked && Boolean(model?.newPanels || found?.newPanels);
  const suggestion = !isLocked && !newPanelsHelp && found ? found.suggestion : null;
  return { found, newPanelsHelp, suggestion };
}
