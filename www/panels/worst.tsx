/**
 * The table of the worst elements: the values behind the colours. The worker finds them; it is
 * queried while the table is visible, a few times a second during a run.
 */

import '../ui/styles/lists.css';
import { useRef } from 'preact/hooks';
import { useSignal, type ReadonlySignal } from '@preact/signals';
import { colouring, toleranceOf } from '../store/colours/measures.ts';
import { useAnswer } from '../store/use-answer.ts';
import { useApp } from '../store/use-app.ts';
import { Choice } from '../ui/components/fields.tsx';
import { itemByKey } from '../ui/controls/navigation.ts';
import { showElements } from '../viewport/camera.ts';
import type { State } from '../store/state.ts';
import type { RefObject } from 'preact';
import type { WorstElement } from '../pkg/engine/shape_up.js';

const ROWS = 20;
const ASK_EVERY_MS = 300;
/** The option for the measure that colours the faces, or would by default. */
const COLOURS = 'colours';

/** What the table can be about: id and label. */
function choicesOf(state: Readonly<State>): [string, string][] {
  const about = colouring(state);
  const rows = state.document?.constraints ?? [];
  return [
    ...(about && state.model?.faces ? ([[COLOURS, about.label]] as [string, string][]) : []),
    ...rows.map(({ number, label, on }): [string, string] => [
      String(number),
      `Constraint: ${label} on ${on}`,
    ]),
  ];
}

/** The choice in effect: the first one, if the chosen one is gone. */
function inEffect(state: Readonly<State>, chosen: string) {
  const ids = choicesOf(state).map(([id]) => id);
  return ids.includes(chosen) ? chosen : (ids[0] ?? '');
}

export function WorstElements() {
  const { state } = useApp().store;
  const place = useRef<HTMLDivElement>(null);
  const chosen = useSignal('');
  const choices = choicesOf(state);
  const answer = useWorst(place, chosen);
  const isEmpty = !answer || answer.rows.length === 0;
  return (
    <div ref={place}>
      <label class="worst-by">
        By
        <Choice
          aria-label="Worst by"
          value={inEffect(state, chosen.value)}
          options={choices}
          disabled={choices.length === 0}
          onChoose={(id) => {
            chosen.value = id;
          }}
        />
      </label>
      <p class="quiet">{answer?.words}</p>
      {!isEmpty && <Table rows={answer.rows} />}
    </div>
  );
}

/** The worst elements by a choice, and what their values are. */
function useWorst(place: RefObject<Element | null>, chosen: ReadonlySignal<string>) {
  const { store, actions } = useApp();

  async function ask() {
    const now = store.get();
    const by = inEffect(now, chosen.peek());
    const about = by === COLOURS ? colouring(now) : undefined;
    const tolerance = (about ? toleranceOf(now, about) : now.document?.tolerance) ?? undefined;
    const worst = (): Promise<WorstElement[]> | WorstElement[] => {
      if (by === '') return [];
      if (about) return actions.ask.worstFaces(about.id, ROWS, tolerance);
      return actions.ask.worstConstraints(Number(by), ROWS, tolerance);
    };
    const rows = await actions.reportErrors(worst());
    if (!rows) return undefined;
    const what = about?.words ?? 'largest distance of a vertex from the shape of its constraint';
    const none = by && `No ${about ? 'face' : 'constraint'} has a value.`;
    return { rows, words: rows.length > 0 ? `The ${what}.` : none || 'There are no constraints.' };
  }

  function follow() {
    const { numbers, running, document, tolerances, measure } = store.state;
    return [chosen.value, numbers, running, document, tolerances, measure];
  }

  return useAnswer(place, ASK_EVERY_MS, follow, ask);
}

function Table({ rows }: { rows: WorstElement[] }) {
  const app = useApp();
  const buttons = useRef<(HTMLButtonElement | null)[]>([]);
  return (
    <table class="worst-elements" aria-label="Worst elements">
      <thead>
        <tr>
          <th scope="col">Element</th>
          <th scope="col">Constraint</th>
          <th scope="col" class="figure">
            Error
          </th>
        </tr>
      </thead>
      <tbody
        onKeyDown={(event) => {
          const all = buttons.current.filter((button) => button !== null);
          itemByKey(event, all, { along: 'y', wraps: false, ends: true })?.focus();
        }}
      >
        {/* The focus stays at a rank, whatever element has it. */}
        {rows.map((worst, rank) => (
          <tr key={rank}>
            <th scope="row">
              <button
                ref={(button) => {
                  buttons.current[rank] = button;
                }}
                type="button"
                title="Select and zoom to it"
                onClick={() => showElements(app, worst)}
              >
                {worst.element}
              </button>
            </th>
            <td>{worst.about}</td>
            <td class="figure">{worst.words}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
