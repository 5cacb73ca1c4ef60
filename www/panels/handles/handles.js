/** The handles: how many, and what to do with the selected ones. */

import { element } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import { sizeOfSelection } from '../../store/selection.js';

/**
 * @param {HTMLElement} place
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../store/actions.js").Actions} actions
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 */
export function handlesPanel(place, store, actions, solver) {
  const summary = element('p');
  const button = (
    /** @type {string} */ label,
    /** @type {string} */ title,
    /** @type {() => void} */ onclick,
  ) => element('button', { title, onclick }, label);
  const add = button('Make handle', 'Make the selected vertices handles (H)', () =>
    actions.addHandles(actions.chosenVertices(), false),
  );
  const fix = button('Fix', 'Hold the selected vertices exactly where they are', () =>
    actions.addHandles(actions.chosenVertices(), true),
  );
  const remove = button('Remove', 'Let the selected handles go (Shift+H)', () =>
    actions.removeHandles(actions.chosenVertices()),
  );
  const row = element('div.handles-row', add, fix, remove);
  place.replaceChildren(summary, row);
  let asked = false;

  store.subscribe(['document', 'selection'], ({ document, selection }) => {
    const handles = document?.handles ?? [];
    const fixed = handles.filter((handle) => handle.fixed).length;
    const chosen = sizeOfSelection(selection) > 0;
    summary.className = 'quiet';
    summary.textContent = wordsFor(handles.length, fixed);
    const pinned = document?.pinned.length ?? 0;
    // Without constraints nothing moves, and that something is pinned would only puzzle.
    if (pinned > 0 && document?.constraints.length) {
      summary.textContent += ` ${count(pinned, 'vertex is', 'vertices are')} fixed automatically, because nothing else holds that part. Add a handle to hold it where you want.`;
    }
    add.disabled = fix.disabled = !chosen;
    remove.disabled = !handles.some((handle) => isChosen(handle.vertex));
    if (remove.disabled || asked) return;
    asked = true;
    actions.reportErrors(
      import('./handle-details.js').then(({ handleDetails }) =>
        place.append(handleDetails(store, actions, solver)),
      ),
    );
  });

  /** @param {number} vertex */
  function isChosen(vertex) {
    return actions.chosenVertices().includes(vertex);
  }
}

/**
 * @param {number} all
 * @param {number} fixed of them
 */
function wordsFor(all, fixed) {
  if (all === 0) return 'None. Double-click a vertex to make one.';
  const share = fixed === all ? ', fixed' : fixed > 0 ? `, ${fixed} of them fixed` : '';
  return `${count(all, 'handle')}${share}. Drag the blue handles in the view.`;
}
