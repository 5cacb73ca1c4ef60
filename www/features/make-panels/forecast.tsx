/** How far one shape of all panels will move the mesh, and buttons for changes that reduce it. */

import { isLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import { useForecastWords } from '../../store/use-forecast-words.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { openEdit } from './edit-dialog.tsx';
import type { ForecastWords, MeshSuggestion } from '../../pkg/engine/shape_up.js';

/** How far the mesh will move for one shape of all panels, and what would reduce that. */
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

/** Lays out panels along the lines of curvature, on the original shape. */
export function NewPanelsButton({ isShown, isNext }: { isShown: boolean; isNext: boolean }) {
  const { store, actions } = useApp();
  async function layOut() {
    if (store.get().document?.constraints.length) await actions.reset();
    actions.look({ corner: 'new-panels' });
  }
  return (
    <Button
      class={isShown && isNext ? 'bordered suggestion next' : 'bordered suggestion'}
      hidden={!isShown}
      onClick={() => actions.reportErrors(layOut())}
    >
      New panels along the curvature
    </Button>
  );
}

/** Opens the operation that reduces the move, on the original shape. */
export function SuggestionButton({
  suggestion,
  isNext,
}: {
  suggestion: MeshSuggestion | null;
  isNext: boolean;
}) {
  const app = useApp();
  const { store, actions } = app;
  async function apply() {
    if (!suggestion) return;
    if (store.get().document?.constraints.length) await actions.reset();
    await openEdit(app, suggestion.operation);
  }
  return (
    <Button
      class={suggestion && isNext ? 'bordered suggestion next' : 'bordered suggestion'}
      aria-haspopup="dialog"
      hidden={!suggestion}
      onClick={() => actions.reportErrors(apply())}
    >
      {suggestion?.label}
    </Button>
  );
}
