/** The dialog of Refine: how, how often, and how many faces that makes. */

import './refine.css';
import { openDialog } from '../../ui/controls/dialog.js';
import { button, choice } from '../../ui/controls/fields.js';
import { element, setText } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import { meshActions } from '../../store/mesh-actions.js';

/** @type {[string, string][]} */
const SCHEMES = [
  ['catmull-clark', 'Catmull-Clark, smooth'],
  ['linear', 'Linear, same shape'],
];
/** @type {[string, string]} */
const FOR_TRIANGLES = ['loop', 'Loop, smooth'];
/** A turn that stays sharp, in degrees. */
const KEEP = 75;

/** @param {import("../../app/context.js").AppContext} app */
export function openRefine({ store, solver, actions, alerts }) {
  const refining = meshActions(store, solver, actions);
  const { geometry } = solver;
  const offsets = geometry?.connectivity.faceOffsets ?? new Uint32Array(1);
  const triangles = geometry?.connectivity.faceIndices.length === 3 * (offsets.length - 1);
  const hasRows = store.get().document?.constraints.some((row) => row.enabled) ?? false;

  const scheme = choice({}, show, triangles ? [FOR_TRIANGLES, ...SCHEMES] : SCHEMES);
  const levels = choice({}, show, [
    ['1', 'Once'],
    ['2', 'Twice'],
    ['3', 'Three times'],
  ]);
  const keep = element('input', {
    ...{ type: 'number', min: '0', max: '180', step: '1', value: String(KEEP) },
  });
  const said = element('p', { 'aria-live': 'polite' });
  const refine = button('Refine now', () => start(false), {
    class: hasRows ? 'bordered' : 'primary',
  });
  const solve = button('Refine and solve', () => start(true), {
    class: 'primary',
    title: 'Solves, refines and solves again, level by level; Pause ends it',
    hidden: !hasRows,
  });
  const how = () => ({
    scheme: /** @type {"catmull-clark" | "linear" | "loop"} */ (scheme.value),
    levels: Number(levels.value),
    keep: keep.validity.valid && keep.value !== '' ? keep.valueAsNumber : KEEP,
  });

  /** Says beforehand what comes of it. */
  function show() {
    const { faces, vertices } = refining.counts(how(), triangles);
    const now = count(store.get().model?.faces ?? 0, 'face');
    const words = `${now} become ${count(faces, 'face')}, with ${count(vertices, 'vertex', 'vertices')}.`;
    setText(said, words);
  }

  /** @param {boolean} solves */
  async function start(solves) {
    const asked = how();
    dialog.close();
    const lost = await actions.reportErrors(refining.refine(asked, solves));
    if (lost?.length) alerts.notice(lost.join(' '));
  }

  const dialog = openDialog(
    { id: 'refine', title: 'Refine', light: true },
    element(
      'div.dialog-body',
      element('label', element('span', 'New faces'), scheme),
      element('label', element('span', 'How often'), levels),
      element('label', element('span', 'Keep turns above, in degrees'), keep),
      said,
      element(
        'p.quiet',
        'The boundary stays a curve of its own; creases and corners that turn by more stay sharp. Sets, constraints and handles go along. “Moved” is measured from the refined original.',
      ),
      element('div.dialog-buttons', solve, refine),
    ),
  );
  show();
}
