/** The handles: their number, and buttons and fields for the selected ones. */

import './handles.css';
import { areHandlesLocked, draggableInWords } from '../../store/handles.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { count, groupDigits } from '../../ui/words.ts';
import { SelectedHandles } from './selected.tsx';
import type { Document as SceneDocument } from '../../pkg/engine/shape_up.js';
import type { State } from '../../store/state.ts';

export function Handles() {
  const { state } = useApp().store;
  const { document } = state;
  return (
    <>
      <p class="quiet">{document && wordsFor(document, state)}</p>
      {document && <Automatic scene={document} />}
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

/** Says which vertices are fixed without handles, and makes them handles. */
function Automatic({ scene }: { scene: SceneDocument }) {
  const { actions } = useApp();
  const { pinned, constraints } = scene;
  // Without constraints nothing moves, so pinned vertices do not matter.
  if (pinned.length === 0 || constraints.length === 0) return null;
  const [are, parts, make] =
    pinned.length === 1
      ? ['vertex is', 'that part', 'Make it a handle']
      : ['vertices are', 'those parts', 'Make them handles'];
  return (
    <p class="quiet">
      {`${groupDigits(pinned.length)} ${are} fixed automatically, because nothing else holds ${parts}. `}
      {!areHandlesLocked(scene) && (
        <Button class="small bordered" onClick={() => actions.addHandles([...pinned], false)}>
          {make}
        </Button>
      )}
    </p>
  );
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
