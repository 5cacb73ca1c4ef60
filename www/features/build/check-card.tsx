/** The build check: five numbers with their limits; clicking one shows its worst element. */

import { LOCKED, isLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { showElements } from '../../viewport/camera.ts';
import type { AppContext } from '../../app/context.ts';
import type { CheckRow, CheckWords, KindWords } from '../../pkg/engine/shape_up.js';
import type { Parts } from './parts.ts';

const MARKS = { none: '–', met: '✓', missed: '✗' };

/** The press that makes all panels of this kind, within a tolerance. */
export type MakePanels = (app: AppContext, kind: KindWords, how: { within: number }) => unknown;

export function CheckCard({ parts, makePanels }: { parts: Parts; makePanels: MakePanels }) {
  const app = useApp();
  const { state } = app.store;
  const { model, kinds } = state;
  const isFixed = isLocked(state, 'constraints');
  const card = parts.card.value;
  if (!card) return null;
  const { report, words } = card;
  const { suggestions, otherwise, change } = report.tighten;
  /** The suggestion that suits the panels. */
  const at = suggestions.findIndex(({ constraint }) =>
    model?.panels.some(({ kind, reason }) => kind === constraint && !reason),
  );
  function tighten() {
    const { constraint, within } = suggestions[at];
    const kind = kinds.find(({ id }) => id === constraint);
    return kind && makePanels(app, kind, { within });
  }
  return (
    <div class="check-card">
      <ul class="check-rows">
        {report.check.map((row, k) => (
          <Row key={row.id} row={row} words={words.check[k]} />
        ))}
      </ul>
      <div class="tighten">
        <Button
          class={at < 0 || isFixed ? 'bordered' : 'primary'}
          aria-describedby="tighten-reason"
          disabled={at < 0 || isFixed}
          title={isFixed ? LOCKED : ''}
          onClick={tighten}
        >
          Meet the limits
        </Button>
        <p class="quiet" id="tighten-reason">
          {words.suggestions[at] ?? otherwise}
        </p>
        {at < 0 && change && (
          <Button onClick={() => parts.change({ [change.setting]: change.value })}>
            {change.label}
          </Button>
        )}
      </div>
      <p class="quiet">{words.offset}</p>
      {report.problems.map((problem) => (
        <p key={problem} class="notice">
          {problem}
        </p>
      ))}
    </div>
  );
}

/** The row whose value and limits are those of the offset, above the card. */
const SAFE = 'safe_distance';

function Row({ row: { id, label, met, worst }, words }: { row: CheckRow; words: CheckWords }) {
  const app = useApp();
  const state = met === null ? 'none' : met ? 'met' : 'missed';
  const inside = (
    <>
      <span class="mark" aria-hidden="true">
        {MARKS[state]}
      </span>
      <span class="label">{label}</span>
      {id !== SAFE && (
        <>
          <span class="figure">{words.value}</span>
          <span class="quiet bound">{words.limit}</span>
        </>
      )}
      {met === false && (
        <span class="quiet missed">
          {words.state}. {words.remedy}
        </span>
      )}
    </>
  );
  function show() {
    if (worst === 'none') return;
    if ('panel' in worst) showElements(app, { vertices: [], faces: [worst.panel] });
    else showElements(app, { vertices: 'edge' in worst ? worst.edge : [worst.vertex], faces: [] });
  }
  return (
    <li data-state={state}>
      {worst === 'none' ? (
        <div title={words.meaning}>{inside}</div>
      ) : (
        <button
          type="button"
          title={`${words.meaning} A click shows where it is worst.`}
          onClick={show}
        >
          {inside}
        </button>
      )}
    </li>
  );
}
