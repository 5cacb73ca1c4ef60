/**
 * Attributes of the body for the style sheets: `data-next` is the next step (`shape`, `run` or
 * `build`), whose button is filled, and `data-moves` is whether the model moves, which hides the
 * overlays in small windows.
 */

import './next-step.css';
import type { Store } from '../../store/state.ts';

export function followNextStep(store: Store) {
  const { dataset } = document.body;
  store.subscribe(
    ['document', 'model', 'running', 'converged', 'numbers', 'dragged'],
    ({ document: scene, model, running, converged, numbers, dragged }) => {
      const moves = String(running || dragged.length > 0);
      if (dataset.moves !== moves) dataset.moves = moves;
      const isConstrained = scene?.constraints.some(({ enabled }) => enabled) ?? false;
      const isMet = converged && numbers?.exact?.met !== false;
      let next = 'run';
      if (!isConstrained && model?.panels.some(({ reason }) => !reason)) next = 'shape';
      else if (!running && isConstrained && isMet && model?.faces) next = 'build';
      if (dataset.next !== next) dataset.next = next;
    },
  );
}
