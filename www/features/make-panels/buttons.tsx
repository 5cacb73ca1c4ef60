/**
 * Buttons that make all panels one shape, and those that change the mesh. A disabled one gives the
 * reason; if a change of the mesh is needed first, there is a button for that instead.
 */

import './make-panels.css';
import type { ComponentChildren } from 'preact';
import { nextStep } from '../../store/next-step.ts';
import { LOCKED, isLocked, offersPanels, panelsCard } from '../../store/panels-card.ts';
import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Drawing } from '../../ui/kinds/drawing.tsx';
import { openEdit } from './edit-dialog.tsx';
import { NewPanelsButton, SuggestionButton, useForecast, type Forecast } from './forecast.tsx';
import { makePanels } from './press.ts';
import type { KindWords } from '../../pkg/engine/shape_up.js';

/** Describes the buttons. */
const REASON = 'make-panels-reason';

/** The buttons in the step, where they are unless the card over the view has them. */
export function PanelsInStep() {
  const { state } = useApp().store;
  const card = panelsCard(state);
  const isShown = offersPanels(state) && card !== 'offer';
  // A verdict in the view has the next step.
  const next = card || state.corner === 'new-panels' ? null : nextStep(state);
  const changesMesh = next === 'shape' || next === 'change';
  // Constraints that are only weighed can be beyond the tolerance, which one press meets.
  const isNext = changesMesh || next === 'choose';
  const forecast = useForecast(isNext);
  if (!isShown) return null;
  return (
    <div id="make-panels" role="group" aria-label="Make panels">
      <PanelButtons isBelow forecast={isNext ? forecast : null} changesMesh={changesMesh} />
    </div>
  );
}

/**
 * The reasons and the buttons.
 * @param isBelow whether the reasons are below the buttons
 * @param forecast by which one of the buttons is the next step; null if none is
 * @param changesMesh whether changes of the mesh are offered that reduce the move
 * @param between the reasons and the buttons
 * @param children after the last button
 */
export function PanelButtons({
  isBelow = false,
  forecast,
  changesMesh,
  between,
  children,
}: {
  isBelow?: boolean;
  forecast: Forecast | null;
  changesMesh: boolean;
  between?: ComponentChildren;
  children?: ComponentChildren;
}) {
  const { kinds, model } = useApp().store.state;
  const reasonOf = new Map(model?.panels.map(({ kind, reason }) => [kind, reason]));
  // Kinds are listed from the weakest to the strongest requirement; here the strongest comes first.
  const offered = kinds.filter((kind) => kind.panels !== null && reasonOf.has(kind.id)).reverse();
  const possible = offered.filter(({ id }) => !reasonOf.get(id));
  /** A change of the mesh that helps comes before the shape, which is known once the forecast is. */
  const change = changesMesh ? forecast : null;
  const isChanged = Boolean(change?.newPanelsHelp || change?.suggestion);
  const best =
    forecast && forecast.found !== undefined && !isChanged
      ? (possible.find(({ id }) => id === forecast.found?.recommended) ?? possible.at(0))
      : undefined;
  const reasons = new Set(offered.map(({ id }) => reasonOf.get(id)).filter(Boolean));
  const suggestion = model?.panelSuggestion;
  const words = suggestion ? suggestion.words : [...reasons].join(' ');
  const why = words && (
    <p class="quiet" id={REASON}>
      {words}
    </p>
  );
  return (
    <>
      {!isBelow && why}
      {between}
      <div>
        {change && <NewPanelsButton isShown={change.newPanelsHelp} isNext />}
        {suggestion ? (
          <ChangeFirst {...suggestion} isNext={change !== null && !isChanged} />
        ) : (
          offered.map((kind) => (
            <KindButton
              key={kind.id}
              kind={kind}
              reason={reasonOf.get(kind.id) ?? ''}
              isNext={kind === best}
            />
          ))
        )}
        {change && <SuggestionButton suggestion={change.suggestion} isNext />}
        {children}
      </div>
      {isBelow && why}
    </>
  );
}

function KindButton({
  kind,
  reason,
  isNext,
}: {
  kind: KindWords;
  /** why it is not possible, if it is not */
  reason: string;
  isNext: boolean;
}) {
  const app = useApp();
  return (
    <Button
      class={isNext ? 'bordered next' : 'bordered'}
      disabled={Boolean(reason)}
      title={reason || kind.summary}
      style={{ '--chip': `rgb(${kind.colour.join(' ')})` }}
      aria-describedby={reason ? REASON : undefined}
      onClick={() => makePanels(app, kind)}
    >
      <Drawing of={kind.sketch} />
      <span>Make panels {kind.panels}</span>
    </Button>
  );
}

/** Changes the mesh, which is needed first. */
function ChangeFirst({
  label,
  operation,
  isNext,
}: {
  label: string;
  operation: string;
  isNext: boolean;
}) {
  const app = useApp();
  const isFixed = isLocked(app.store.state, 'mesh');
  return (
    <Button
      class={isNext && !isFixed ? 'bordered next' : 'bordered'}
      aria-haspopup="dialog"
      aria-describedby={REASON}
      disabled={isFixed}
      title={isFixed ? LOCKED : ''}
      onClick={() => app.actions.reportErrors(openEdit(app, operation))}
    >
      {label}
    </Button>
  );
}

/** The buttons that change the mesh. */
export const MeshTools = () => (
  <>
    <CommandButton of="new-panels">New panels</CommandButton>
    <CommandButton of="refine" aria-haspopup="dialog">
      Refine
    </CommandButton>
    <CommandButton of="edit-mesh" aria-haspopup="dialog">
      Edit mesh
    </CommandButton>
  </>
);
