/** How far the mesh will move for one shape of all panels, and what would reduce that. */

import { isLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import { useForecastWords } from '../../store/use-forecast-words.ts';
import type { ForecastWords, MeshSuggestion } from '../../pkg/engine/shape_up.js';

export interface Forecast {
  /** null if there is none, undefined until it is known */
  found: ForecastWords | null | undefined;
  /** whether panels along the lines of curvature would help */
  newPanelsHelp: boolean;
  /** a simple change of the mesh that would reduce the move, unless new panels are the better choice */
  suggestion: MeshSuggestion | null;
}

/** @param isWanted whether it is shown */
export function useForecast(isWanted: boolean): Forecast {
  const { model, document } = useApp().store.state;
  const found = useForecastWords(isWanted);
  const isFixed = isLocked({ document }, 'mesh');
  const newPanelsHelp = !isFixed && Boolean(model?.newPanels || found?.newPanels);
  const suggestion = !isFixed && !newPanelsHelp && found ? found.suggestion : null;
  return { found, newPanelsHelp, suggestion };
}
