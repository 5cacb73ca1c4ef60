/** The handles: their number, and buttons and fields for the selected ones. */

import './handles.css';
import { areHandlesLocked, draggableInWords } from '../../store/handles.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { count, groupDigits } from '../../ui/words.ts';
import { SelectedHandles } from './selected.tsx';
import type { Document as SceneDocument } from '../../pkg/engine/shape_up.js';
import type { State } from '../../store/state.ts';

export function Handles() {
  const { state } = useApp().store;
  const { document } = state;
  return (
    <>
      <p class="quiet">{document && wordsFor(document, state) + automatic(document)}</p>
      <HandleButtons />
      <SelectedHandles />
    </>
  );
}

/** Says how many handles there are, and what to do with them. */
function wordsFor(scene: SceneDocument, state: Readonly<State>) {
  const all = scene.handles.length;
  if (all === 0)
    return areHandlesLocked(scene) || state.renderer === 'none'
      ? 'No handles.'
      : 'No handles yet. Double-click a vertex to make one, then drag it.';
  const fixed = scene.handles.filter((handle) => handle.fixed).length;
  const share = fixed === all ? ', fixed' : fixed > 0 ? `, ${fixed} of them fixed` : '';
  const one = draggableInWords(state);
  return `${count(all, 'handle')}${share}.${one && ` Drag ${one} in the view.`}`;
}

/** Says which vertices are fixed without handles. */
function automatic({ pinned, constraints }: SceneDocument) {
  // Without constraints nothing moves, so pinned vertices do not matter.
  if (pinned.length === 0 || constraints.length === 0) return '';
  return pinned.length === 1
    ? ' 1 vertex is fixed automatically, because nothing else holds that part. Add a handle to hold it where you want.'
    : ` ${groupDigits(pinned.length)} vertices are fixed automatically, because nothing else holds those parts. Add handles to hold them where you want.`;
}

/** What can be done with the selected vertices. */
function HandleButtons() {
  const { store, actions } = useApp();
  const { document, selection } = store.state;
  if (sizeOfSelection(selection) === 0) return null;
  const vertices = new Set(actions.selectedVertices());
  const hasHandle = document?.handles.some(({ vertex }) => vertices.has(vertex));
  return (
    <div class="handles-row">
      <CommandButton of="add-handles" class="">
        Make handle
      </CommandButton>
      <button
        type="button"
        title="Fix the selected vertices where they are"
        onClick={() => actions.holdSelected(true)}
      >
        Fix
      </button>
      <CommandButton of="remove-handles" class="" disabled={!hasHandle}>
        Remove
      </CommandButton>
    </div>
  );
}
