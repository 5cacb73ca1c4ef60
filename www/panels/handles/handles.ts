/** The handles: their number, and buttons for the selected ones. */

import { areHandlesLocked, draggableInWords } from '../../store/handles.ts';
import { element } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import { handleDetails } from './handle-details.ts';
import type { SceneDocument } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

export function handlesPanel(place: HTMLElement, { store, actions }: AppContext) {
  const summary = element('p.quiet');
  const button = (label: string, title: string, onclick: () => unknown) =>
    element('button', { title, onclick }, label);
  const add = button('Make handle', 'Turn the selected vertices into handles (H)', () =>
    actions.holdSelected(false),
  );
  const fix = button('Fix', 'Fix the selected vertices where they are', () =>
    actions.holdSelected(true),
  );
  const remove = button('Remove', 'Remove the selected handles (Shift+H)', () =>
    actions.releaseSelected(),
  );
  const row = element('div.handles-row', add, fix, remove);
  place.replaceChildren(summary, row, handleDetails(store, actions));

  store.subscribe(['document', 'selection'], ({ document, selection }) => {
    const handles = document?.handles ?? [];
    const chosen = sizeOfSelection(selection) > 0;
    summary.textContent = document ? wordsFor(document) : '';
    const pinned = document?.pinned.length ?? 0;
    // Without constraints nothing moves, so pinned vertices do not matter.
    if (pinned > 0 && document?.constraints.length) {
      summary.textContent += ` ${count(pinned, 'vertex is', 'vertices are')} fixed automatically, because nothing else holds that part. Add a handle to hold it where you want.`;
    }
    add.disabled = fix.disabled = !chosen;
    const vertices = new Set(actions.selectedVertices());
    remove.disabled = !handles.some(({ vertex }) => vertices.has(vertex));
    // Hidden if no button could do anything.
    row.hidden = !chosen && handles.length === 0;
  });
}

/** Says how many handles there are, and what to do with them. */
function wordsFor(scene: SceneDocument) {
  const all = scene.handles.length;
  const isLocked = areHandlesLocked(scene);
  if (all === 0)
    return isLocked
      ? 'No handles.'
      : 'No handles yet. Double-click a vertex to make one, then drag it.';
  const fixed = scene.handles.filter((handle) => handle.fixed).length;
  const share = fixed === all ? ', fixed' : fixed > 0 ? `, ${fixed} of them fixed` : '';
  const one = draggableInWords(scene);
  return `${count(all, 'handle')}${share}.${one && ` Drag ${one} in the view.`}`;
}
