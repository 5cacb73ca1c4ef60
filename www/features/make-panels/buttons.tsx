/**
 * Buttons that make all panels one shape, and those that change the mesh. A disabled one gives the
 * reason; if a change of the mesh is needed first, there is a button for that instead.
 */

import './make-panels.css';
import type { ComponentChildren } from 'preact';
import { LOCKED, isLocked, offersPanels, panelsCard } from '../../store/panels-card.ts';
import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Drawing } from '../../ui/kinds/drawing.tsx';
import { openEdit } from './edit-dialog.tsx';
import { makePanels } from './press.ts';
import type { KindWords } from '../../pkg/engine/shape_up.js';

/** Describes the buttons. */
const REASON = 'make-panels-reason';

/** The buttons in the step, where they are unless the card over the view has them. */
export function PanelsInStep() {
  const { state } = useApp().store;
  if (!offersPanels(state) || panelsCard(state) === 'offer') return null;
  return (
    <div id="make-panels" role="group" aria-label="Make panels">
      <PanelButtons isBelow />
    </div>
  );
}

/**
 * The reasons and the buttons.
 * @param isBelow whether the reasons are below the buttons
 * @param recommended id of the kind that moves the mesh least
 * @param between the reasons and the buttons
 * @param before the first button
 * @param children after the last button
 */
export function PanelButtons({
  isBelow = false,
  recommended,
  between,
  before,
  children,
}: {
  isBelow?: boolean;
  recommended?: string;
  between?: ComponentChildren;
  before?: ComponentChildren;
  children?: ComponentChildren;
}) {
  const { kinds, model } = useApp().store.state;
  const reasonOf = new Map(model?.panels.map(({ kind, reason }) => [kind, reason]));
  // Kinds are listed from the weakest to the strongest requirement; here the strongest comes first.
  const offered = kinds.filter((kind) => kind.panels !== null && reasonOf.has(kind.id)).reverse();
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
        {before}
        {suggestion ? (
          <ChangeFirst {...suggestion} />
        ) : (
          offered.map((kind) => (
            <KindButton
              key={kind.id}
              kind={kind}
              reason={reasonOf.get(kind.id) ?? ''}
              isRecommended={kind.id === recommended}
            />
          ))
        )}
        {children}
      </div>
      {isBelow && why}
    </>
  );
}

function KindButton({
  kind,
  reason,
  isRecommended,
}: {
  kind: KindWords;
  /** why it is not possible, if it is not */
  reason: string;
  isRecommended: boolean;
}) {
  const app = useApp();
  return (
    <Button
      class={isRecommended ? 'bordered recommended' : 'bordered'}
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
function ChangeFirst({ label, operation }: { label: string; operation: string }) {
  const app = useApp();
  const isFixed = isLocked(app.store.state, 'mesh');
  return (
    <Button
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
