/** The build check: five numbers with their limits; clicking one shows its worst element. */

import { button } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { count, groupDigits } from '../../ui/format.ts';
import type { BuildCard, BuildReport, CheckRow } from '../../solver/types.ts';
import type { State } from '../../store/state.ts';

type Remedy = BuildReport['tighten']['remedies'][number];

const KEEPS = { corner: 'Corners keep', face: 'Panels keep', edge: 'Beams keep' };
/** The noun for a part of each product. */
const NOUNS = { panels: 'panel', fins: 'fin', paper: 'piece' };
/** Smallest length that is shown, in millimetres. */
const LEAST_MM = 0.01;

/** @param show shows an element of the mesh */
export function checkCard(
  show: (worst: CheckRow['worst']) => void,
  tighten: (remedy: Remedy) => void,
) {
  const words = element('p.quiet');
  const list = element('ul.check-rows');
  const problems = element('div');
  /** The remedy on offer. */
  let remedy: Remedy | undefined;
  const reason = element('p.quiet', { id: 'tighten-reason' });
  const press = button('Tighten', () => remedy && tighten(remedy), {
    'aria-describedby': 'tighten-reason',
  });
  const card = element(
    'div.check-card',
    list,
    element('div.tighten', press, reason),
    words,
    problems,
  );
  return {
    card,
    /** @param metres per unit of the mesh */
    update(report: BuildCard, { model, kinds }: Pick<State, 'model' | 'kinds'>, metres: number) {
      const { remedies, otherwise } = report.tighten;
      remedy = remedies.find(({ constraint }) =>
        model?.panels.some(({ kind, reason }) => kind === constraint && !reason),
      );
      press.disabled = !remedy;
      const panels = kinds.find(({ id }) => id === remedy?.constraint)?.panels;
      const within = remedy && millimetres(1000 * metres * remedy.within);
      setText(reason, remedy ? `Makes all panels ${panels} within ${within}` : otherwise);
      list.replaceChildren(...report.check.map((row) => checkRow(row, show)));
      const { offset } = report;
      const how = offset?.exact ? 'exactly' : 'as nearly as possible';
      const kept =
        offset && `${KEEPS[offset.kind]} a distance of ${millimetres(offset.distance_mm)} ${how}`;
      words.textContent = kept ? `${kept}${offset.why_not && `; ${offset.why_not}`}.` : '';
      problems.replaceChildren(...report.problems.map((problem) => element('p.notice', problem)));
    },
  };
}

function checkRow(
  { label, value, limit, unit, met, worst, failed }: CheckRow,
  show: (worst: CheckRow['worst']) => void,
) {
  const inWords = (size: number) => (unit === 'deg' ? `${mm(size)}°` : millimetres(size));
  const state = met === null ? 'none' : met ? 'met' : 'missed';
  const figure = value === null ? 'not available' : inWords(value);
  const bound = limit === null ? 'no limit' : `≤ ${inWords(limit)}`;
  const parts = [
    element('span.mark', { 'aria-hidden': 'true' }, { none: '–', met: '✓', missed: '✗' }[state]),
    element('span.label', label),
    element('span.figure', figure),
    element('span.quiet.bound', bound),
    failed > 0 && element('span.quiet.missed', `not met by ${groupDigits(failed)}`),
  ];
  const title = 'Show where it is worst';
  const inside =
    worst === 'none'
      ? element('div', ...parts)
      : element('button', { title, onclick: () => show(worst) }, ...parts);
  return element('li', { 'data-state': state }, inside);
}

/** One line about the panels on the sheets. */
export function sheetsInWords({
  product,
  sheets,
  placed,
  parts,
  used,
  types,
  frame,
  paper,
}: BuildReport) {
  const noun = NOUNS[product];
  const all = placed === parts ? count(parts, noun) : `${placed} of ${count(parts, noun)}`;
  const words = [`${all} on ${count(sheets, 'sheet')}`, `${Math.round(100 * used)} % covered`];
  if (product === 'panels') words.push(`${count(types, 'type')} of panels`);
  if (frame)
    words.push(`${count(frame.node_types, 'type')} of nodes within ${frame.alike_deg}\u00b0`);
  if (paper) words.push(`${count(paper.tabs, 'tab')}`);
  return words.join(', ');
}

/** Parts missing from the sheets or hard to read. */
export function warnings({
  too_large: large,
  not_cut: uncut,
  dropped_names: dropped,
  small_names: small,
  unnamed,
  product,
  dropped_holes: undrilled,
  paper,
}: BuildReport) {
  const bare = paper?.without_tab ?? [];
  const creased = paper?.creased ?? 0;
  const some = (names: string[]) =>
    names.length > 6
      ? `${names.slice(0, 6).join(', ')} and ${names.length - 6} more`
      : names.join(', ');
  return [
    large.length > 0 && `Larger than the sheet: ${some(large)}. They are left out, not scaled.`,
    uncut.length > 0 && `Not cut: ${some(uncut)}.`,
    dropped > 0 && `No room for ${count(dropped, 'name')} of neighbours.`,
    unnamed.length > 0 &&
      `${count(unnamed.length, NOUNS[product])} ${unnamed.length > 1 ? 'have' : 'has'} no room for a name: ${some(unnamed)}.`,
    small > 0 && `${count(small, 'part has', 'parts have')} a name smaller than 2 mm.`,
    undrilled > 0 && `No room for ${count(undrilled, 'hole')}.`,
    bare.length > 0 && `No tab between ${some(bare)}.`,
    creased > 0 &&
      `${count(creased, 'panel is', 'panels are')} not flat and creased along a diagonal.`,
  ].filter((line) => line !== false);
}

/**
 * A length of the building, in metres from 10 m on.
 * @param size in mm
 */
export function millimetres(size: number) {
  return Math.abs(size) < 1e4 ? `${mm(size)} mm` : `${mm(size / 1000)} m`;
}

/** @param value in mm or degrees */
function mm(value: number) {
  if (Math.abs(value) < LEAST_MM) return value === 0 ? '0' : `< ${LEAST_MM}`;
  return Math.abs(value) >= 100 ? String(Math.round(value)) : String(Number(value.toPrecision(3)));
}
