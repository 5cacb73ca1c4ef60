/** The log: a report on the file, and the messages since the page was opened. */

import '../ui/styles/lists.css';
import { useState } from 'preact/hooks';
import { frameOf } from '../store/frame.ts';
import { useApp } from '../store/use-app.ts';
import { Button } from '../ui/components/buttons.tsx';
import { count } from '../ui/words.ts';
import { copyText } from '../ui/output.ts';
import { showElements } from '../viewport/camera.ts';
import type { Entry } from '../ui/controls/alerts.ts';
import type { Loaded } from '../solver/types.ts';

const FORMATS = { z: 'z-up', y: 'y-up' };
const NAMES = { error: 'Error', notice: 'Notice', status: '' };

export function Log() {
  return (
    <>
      <h3>File</h3>
      <div class="import-report">
        <File />
      </div>
      <h3>Messages</h3>
      <Messages />
      <Copy />
    </>
  );
}

function File() {
  const { state } = useApp().store;
  const { model } = state;
  if (!model) return null;
  const lines = factsOf(model, frameOf(state));
  return (
    <>
      {lines.map((line) => (
        <p key={line}>{line}</p>
      ))}
      {model.problems.length + model.notes.length > 0 && (
        <ul aria-label="Problems and notes">
          {model.problems.map((problem) => (
            <Problem key={problem.message} {...problem} />
          ))}
          {model.notes.map((note) => (
            <li key={note} class="quiet">
              {note}
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

function Problem({ message, flaw }: Loaded['problems'][number]) {
  const app = useApp();
  const { actions } = app;

  /** Selects the elements that have it. */
  async function select(flaw: string) {
    const found = await actions.reportErrors(actions.ask.flawed(flaw));
    if (!found) return;
    const some = found.vertices.length + found.edges.length + found.faces.length;
    if (some > 0) showElements(app, found);
    else actions.setStatus('No elements with this problem are left');
  }

  return (
    <li class="problem">
      <span class="mark" aria-hidden="true">
        !
      </span>
      <span>{message}</span>
      {flaw && (
        <Button
          class="small bordered"
          aria-label={`Select: ${message}`}
          onClick={() => actions.begin(select(flaw))}
        >
          Select
        </Button>
      )}
    </li>
  );
}

/** The messages, the latest first. */
function Messages() {
  const { alerts } = useApp();
  return (
    // Focusable, so that it can be scrolled by keyboard.
    <ol class="log" aria-label="Messages" tabIndex={0}>
      {alerts.journal.toReversed().map((entry) => (
        <Message key={entry.id} {...entry} />
      ))}
    </ol>
  );
}

const Message = ({ time, kind, text }: Entry) => (
  <li class={kind}>
    <time dateTime={time.toISOString()}>{time.toTimeString().slice(0, 8)}</time>
    <span>
      {NAMES[kind] && <strong>{NAMES[kind]}: </strong>}
      {text}
    </span>
  </li>
);

function Copy() {
  const { store, alerts } = useApp();
  const [result, setResult] = useState('');

  async function copy() {
    const { model } = store.get();
    const lines = [
      ...(model
        ? [
            ...factsOf(model, frameOf(store.get())),
            ...model.problems.map(({ message }) => `Problem: ${message}`),
            ...model.notes.map((note) => `Note: ${note}`),
            '',
          ]
        : []),
      ...alerts.journal.map(
        ({ time, kind, text }) =>
          `${time.toISOString()} ${NAMES[kind] && `${NAMES[kind]}: `}${text}`,
      ),
    ];
    setResult(await copyText(`${lines.join('\n')}\n`, 'The browser did not allow copying.'));
  }

  return (
    <p class="log-end">
      <Button onClick={copy}>Copy as text</Button>
      <span class="quiet" aria-live="polite">
        {result}
      </span>
    </p>
  );
}

/** Returns the contents of the file, a sentence each. */
function factsOf(model: Loaded, { units, up, guessed }: ReturnType<typeof frameOf>) {
  const ifGuessed = (is: boolean) => (is ? ' (guessed)' : '');
  const parts = [
    count(model.vertices, 'vertex', 'vertices'),
    count(model.faces, 'face'),
    ...(model.curves > 0 ? [count(model.curves, 'curve')] : []),
    ...(model.tets > 0 ? [count(model.tets, 'tetrahedron', 'tetrahedra')] : []),
    ...(model.groups.length > 0 ? [count(model.groups.length, 'group')] : []),
  ];
  const problems = model.problems.length;
  return [
    `${model.name}: ${parts.join(', ')}`,
    `Unit: ${units || 'unknown'}${ifGuessed(guessed.units)} · ${FORMATS[up]}${ifGuessed(guessed.up)}`,
    problems > 0 ? count(problems, 'kind of problem', 'kinds of problem') : 'No problems',
  ];
}
