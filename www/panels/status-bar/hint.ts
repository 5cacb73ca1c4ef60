/** The hint for the next action. */

import { areHandlesLocked, draggableInWords } from '../../store/handles.ts';
import { nextStep } from '../../store/next-step.ts';
import { panelsCard } from '../../store/panels-card.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import { CTRL, workingKey } from '../../ui/keys.ts';
import type { State } from '../../store/state.ts';

/** Hints for the Select tool, by shape of the drag. */
const SHAPES = { box: 'Drag a box', lasso: 'Draw a lasso', paint: 'Brush' };

/** Returns the hint; empty without a model. */
export function hintOf(state: Readonly<State>) {
  const { kinds, model, document, tool, shape, mode, selection, dragged, display } = state;
  if (!model || !document) return '';
  if (dragged.length > 0) return 'Release to place it · Esc cancels';
  // A docked panel has a next step of its own.
  const next = state.docked ? null : nextStep(state);
  const panels = kinds.flatMap((kind) => kind.panels ?? []).join(' or ');
  if (next === 'shape') return `Next: make its panels ${panels}, or add a constraint`;
  if (next === 'change') return 'Next: other panels for this mesh, or a constraint';
  if (next === 'constrain' && state.flatMap) return 'Next: Export, with the flat map';
  if (next === 'constrain') return 'Next: add a constraint to say what shape its parts shall have';
  const isLocked = areHandlesLocked(document);
  const one = draggableInWords(state);
  if (one && document.handles.some(({ vertex }) => selection.vertices.has(vertex)))
    return `Drag the handle${display.gizmo ? ', an arrow or a square' : ''} · Enter, then arrow keys, moves it`;
  if (sizeOfSelection(selection) > 0) {
    const key = isLocked ? '' : workingKey('H');
    const makes = key && `${key} turns the selection into handles · `;
    return `${makes}Add constraint can use it · Esc clears the selection`;
  }
  if (state.renderer === 'none') return 'Run, Export and the steps work without the 3D view';
  if (tool === 'select') {
    const key = workingKey('V');
    const back = key && ` · ${key} goes back to Drag`;
    return `${SHAPES[shape]} over ${mode} · Shift adds, ${CTRL} removes${back}`;
  }
  if (next === 'choose' && state.verdict && panelsCard(state) === 'verdict')
    return 'Next: see the verdict in the view · drag elsewhere to orbit';
  const { running, converged } = state;
  if (!running && !converged)
    return one
      ? `Next: Run, or drag ${one} · drag elsewhere to orbit`
      : 'Next: Run · drag to orbit';
  const build = next === 'build' ? 'Next: Build · ' : '';
  if (isLocked) return `${build}Drag to orbit, wheel to zoom`;
  if (!one) return `${build}Double-click a vertex to make a handle · drag elsewhere to orbit`;
  return `${build}Drag ${one} · drag elsewhere to orbit, wheel to zoom`;
}
