/** The Refine dialog: scheme, number of levels, and resulting number of faces. */

import './refine.css';
import { openDialog } from '../../ui/controls/dialog.ts';
import { messageOf } from '../../solver/errors.ts';
import type { Refinement } from '../../pkg/engine/shape_up.js';
import { button, choice, setOptions } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { count, length } from '../../ui/format.ts';
import { oneAtATime } from '../../ui/once.ts';
import { meshActions } from '../../store/mesh-actions.ts';
import type { AppContext } from '../../app/context.ts';

const SCHEMES: [string, string][] = [
  ['catmull-clark', 'Catmull-Clark, smooth'],
  ['linear', 'Linear, same shape'],
];
const FOR_TRIANGLES: [string, string] = ['loop', 'Loop, smooth'];
/** The reference of each level of Refine and solve. */
const CLOSE_TO: [string, string][] = [
  ['solved', 'The solved level: faster, smoother'],
  ['original', 'The original: nearer to it'],
];
const FROM = {
  solved: 'Refine and solve measures “Moved” from the last level that was solved.',
  original: '“Moved” is measured from the refined original.',
};
const OFTEN = ['Once', 'Twice', 'Three times', 'Four times', 'Five times'];
/** Default angle in degrees above which creases and corners stay sharp. */
const KEEP = 75;

/** Opens the dialog. */
export const openRefine = oneAtATime(open);

async function open({ store, solver, actions, alerts }: AppContext) {
  const refining = meshActions(store, solver, actions);
  const { geometry } = solver;
  const offsets = geometry?.connectivity.faceOffsets ?? new Uint32Array(1);
  const triangles = geometry?.connectivity.faceIndices.length === 3 * (offsets.length - 1);
  const hasRows = store.get().document?.constraints.some((row) => row.enabled) ?? false;

  const scheme = choice({}, ask, triangles ? [FOR_TRIANGLES, ...SCHEMES] : SCHEMES);
  const levels = choice({}, say);
  const keep = element('input', {
    ...{ type: 'number', min: '0', max: '180', step: '1', value: String(KEEP) },
    onchange: ask,
  });
  const closeTo = choice({}, explain, CLOSE_TO);
  const from = element('span');
  const said = element('p', { 'aria-live': 'polite' });
  const refine = button('Refine now', () => start(false), {
    class: hasRows ? 'bordered' : 'primary',
  });
  const solve = button('Refine and solve', () => start(true), {
    class: 'primary',
    title: 'Solves, refines and solves again, level by level; Pause stops it',
    hidden: !hasRows,
  });
  const how = () => ({
    scheme: scheme.value as 'catmull-clark' | 'linear' | 'loop',
    levels: Number(levels.value),
    keep: keep.validity.valid && keep.value !== '' ? keep.valueAsNumber : KEEP,
  });
  const isAdopted = () => hasRows && closeTo.value === 'solved';

  /** Shows the shape from which “Moved” is measured. */
  function explain() {
    setText(from, isAdopted() ? FROM.solved : FROM.original);
  }

  /** Resulting mesh by level. */
  let made: Refinement[] = [];

  /** Requests the result of each number of levels. */
  async function ask() {
    const { scheme, keep } = how();
    try {
      made = await actions.ask.refinements(scheme, keep);
      setOptions(levels, made.map(words));
      say();
    } catch (error) {
      made = [];
      setText(said, messageOf(error));
    }
    refine.disabled = solve.disabled = made.length === 0;
  }

  /** The option for a number of levels, with its result. */
  function words({ faces, edge }: (typeof made)[number], i: number) {
    const far = length(Number(edge.toPrecision(2)), store.get().document?.units ?? '');
    const times = OFTEN[i] ?? `${i + 1} times`;
    return [String(i + 1), `${times}: ${count(faces, 'face')} of about ${far}`];
  }

  /** Shows the result in advance. */
  function say() {
    const { faces, vertices } = made[Number(levels.value) - 1];
    const now = count(store.get().model?.faces ?? 0, 'face');
    const words = `${now} become ${count(faces, 'face')}, with ${count(vertices, 'vertex', 'vertices')}.`;
    setText(said, words);
  }

  async function start(solves: boolean) {
    const asked = { ...how(), adopt: solves && isAdopted() };
    dialog.close();
    const lost = await actions.reportErrors(refining.refine(asked, solves));
    if (lost?.length) alerts.notice(lost.join(' '));
  }

  const dialog = openDialog(
    { id: 'refine', title: 'Refine', light: true },
    element(
      'div.dialog-body',
      element('label', element('span', 'New faces'), scheme),
      element('label', element('span', 'How many times'), levels),
      element('label', element('span', 'Keep creases above, in degrees'), keep),
      element('label', { hidden: !hasRows }, element('span', 'Each level stays close to'), closeTo),
      said,
      element(
        'p.quiet',
        'The boundary is refined as a curve of its own; creases and corners that turn by more than this angle stay sharp. Sets, constraints and handles are carried over. ',
        from,
      ),
      element('div.dialog-buttons', solve, refine),
    ),
  );
  explain();
  void ask();
}
