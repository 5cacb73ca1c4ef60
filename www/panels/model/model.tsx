/** The contents of the model, and the report on its file, of which a lesson locks only the changes. */

import { isLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { count, groupDigits } from '../../ui/words.ts';
import { showElements } from '../../viewport/camera.ts';
import { FrameFields } from './frame-fields.tsx';
import type { ComponentChildren } from 'preact';
import type { MeshSuggestion } from '../../pkg/engine/shape_up.js';
import type { Loaded } from '../../solver/types.ts';

export function Model() {
  const { model, nothingOpen } = useApp().store.state;
  if (!model) return <p class="quiet">{nothingOpen ? 'Nothing is open.' : 'Loading the model.'}</p>;
  return (
    <>
      <dl class="facts">
        <Fact name="Vertices" value={model.vertices} />
        <Fact name="Faces" value={model.faces} />
        {model.curves > 0 && <Fact name="Curves" value={model.curves} />}
        {model.tets > 0 && <Fact name="Tetrahedra" value={model.tets} />}
        {model.groups.length > 0 && <Fact name="Groups" value={model.groups.length} />}
      </dl>
      <FrameFields model={model} />
      <Groups model={model} />
    </>
  );
}

const Fact = ({ name, value }: { name: string; value: number }) => (
  <>
    <dt>{name}</dt>
    <dd>{groupDigits(value)}</dd>
  </>
);

function Groups({ model: { groups } }: { model: Loaded }) {
  if (groups.length === 0) return null;
  return (
    <Details title={count(groups.length, 'group')}>
      <ul>
        {groups.map(({ name, faces }) => (
          <li key={name}>
            {name}: {count(faces, 'face')}
          </li>
        ))}
      </ul>
    </Details>
  );
}

/** The import report. */
export function ImportReport() {
  const { model } = useApp().store.state;
  // Each file is reported anew.
  return model && <Report key={model} model={model} />;
}

function Report({ model: { problems, notes } }: { model: Loaded }) {
  const { document } = useApp().store.state;
  const isFixed = isLocked({ document }, 'mesh');
  if (problems.length + notes.length === 0) return null;
  const title =
    problems.length > 0
      ? `${count(problems.length, 'kind of problem', 'kinds of problem')} in the file`
      : count(notes.length, 'note');
  return (
    <Details title={title} open={problems.length > 0}>
      <ul>
        {problems.map(({ message, flaw, suggestion }) => (
          <li key={message}>
            {message} {flaw && <Select flaw={flaw} message={message} />}{' '}
            {suggestion && !isFixed && <Repair suggestion={suggestion} />}
          </li>
        ))}
        {notes.map((note) => (
          <li key={note} class="quiet">
            {note}
          </li>
        ))}
      </ul>
    </Details>
  );
}

/** Selects the elements that have a problem. */
function Select({ flaw, message }: { flaw: string; message: string }) {
  const app = useApp();
  const { actions } = app;
  async function select() {
    const found = await actions.reportErrors(actions.ask.flawed(flaw));
    if (!found) return;
    const some = found.vertices.length + found.edges.length + found.faces.length;
    if (some > 0) showElements(app, found);
    else actions.setStatus('No elements with this problem are left');
  }
  return (
    <Button
      class="small bordered"
      aria-label={`Select: ${message}`}
      onClick={() => actions.begin(select())}
    >
      Select
    </Button>
  );
}

/** Changes the mesh so that a problem is gone. */
function Repair({ suggestion: { label, words, operation } }: { suggestion: MeshSuggestion }) {
  const { actions, mesh } = useApp();
  return (
    <Button
      class="small bordered"
      title={words}
      onClick={() => actions.reportErrors(mesh.remesh({ operation }, label))}
    >
      {label}
    </Button>
  );
}

function Details(props: { title: string; open?: boolean; children: ComponentChildren }) {
  const { title, open = false, children } = props;
  return (
    <details class="report" open={open}>
      <summary>{title}</summary>
      {children}
    </details>
  );
}
