/**
 * What comes next, for the style sheets, which make its button the one that is filled: `shape`, `run` or `build`;
 * and whether the model moves, while which nothing lies over it in small windows.
 */

import './next-step.css';

/** @param {import("../../store/state.js").Store} store */
export function followNextStep(store) {
  const { dataset } = document.body;
  store.subscribe(
    ['document', 'model', 'running', 'converged', 'numbers', 'dragged'],
    ({ document: scene, model, running, converged, numbers, dragged }) => {
      const moves = String(running || dragged.length > 0);
      if (dataset.moves !== moves) dataset.moves = moves;
      const asks = scene?.constraints.some(({ enabled }) => enabled) ?? false;
      const isMet = converged && numbers?.exact?.met !== false;
      let next = 'run';
      if (!asks && model?.panels.some(({ reason }) => !reason)) next = 'shape';
      else if (!running && asks && isMet && model?.faces) next = 'build';
      if (dataset.next !== next) dataset.next = next;
    },
  );
}
