/** The panel of the flat map: its errors, its settings, and the look of the two surfaces. */

import { element, setText } from '../../ui/dom.ts';
import { reveal } from '../../ui/reveal.ts';
import { duration, groupDigits, ratio } from '../../ui/format.ts';
import type { FlatMap, Store } from '../../store/state.ts';
import type { FlatMapController } from './flat-map-controller.ts';
import type { Parametrization } from '../../solver/types.ts';

/** Label and tooltip of each polygon weight. */
const WEIGHTS = {
  'inverse-area': ['1 / area', 'A small polygon counts as much as a large one.'],
  one: ['1', 'Large polygons count more than small ones.'],
  lscm: ['|z|² / area', 'On triangles, this is the least-squares conformal map.'],
};
/** Norms that keep the map from shrinking: label and tooltip. */
const NORMS = {
  boundary: ['the boundary', 'The boundary is kept from shrinking; the inside follows.'],
  vertices: ['all vertices', 'All vertices are kept from shrinking, each equally.'],
};
const LOOKS = { checks: ['Checkerboard', ''], errors: ['Error', ''] };
const SQUARES = { least: 8, most: 96, step: 4 };

export function flatMapPanel(place: HTMLElement, store: Store, control: FlatMapController) {
  const facts = element('dl.facts');
  const flipped = element('div.flipped-row');
  const showFlipped = element(
    'button.bordered',
    { onclick: () => control.showFlipped() },
    'Show flipped faces',
  );
  showFlipped.title = 'Selects them on the model, and zooms to them in both pictures';
  const fewerFlips = element('div', { 'aria-live': 'polite' });
  flipped.append(
    element('p.quiet', 'Outlined in red where the map folds over itself.'),
    showFlipped,
    fewerFlips,
  );
  const notice = element('p.notice');
  const again = element('button.small', { onclick: () => control.flatten() }, 'Flatten again');
  const weights = choice('Weight of a polygon', WEIGHTS, (weights) => control.choose({ weights }));
  const norm = choice('Norm over', NORMS, (norm) => control.choose({ norm }));
  const onModel = choice('On the model', LOOKS, (onModel) => control.choose({ onModel }));
  const onMap = choice('On the map', LOOKS, (onMap) => control.choose({ onMap }));
  const squares = element('input', {
    type: 'range',
    id: 'map-squares',
    min: SQUARES.least,
    max: SQUARES.most,
    step: SQUARES.step,
    oninput: () => control.choose({ squares: squares.valueAsNumber }),
  });
  const squaresRow = element(
    'div.field-row',
    element('label', { for: 'map-squares' }, 'Squares'),
    squares,
  );
  const looks = element('div', onModel.row, onMap.row, squaresRow);
  place.replaceChildren(
    element(
      'div.heading-row',
      element('h2', { id: 'heading-flat-map' }, 'Flat map'),
      element(
        'button.small',
        { title: 'Esc', onclick: () => control.close() },
        'Back to the model',
      ),
    ),
    facts,
    flipped,
    notice,
    again,
    weights.row,
    norm.row,
    looks,
  );

  store.subscribe(['flatMap', 'numbers', 'renderer'], (state) => {
    const { flatMap } = state;
    const isNew = place.hidden && flatMap !== null;
    place.hidden = !flatMap;
    if (!flatMap) return;
    // The panel appears above the scroll position, in a step that may be closed.
    if (isNew) reveal(place);
    const { found } = flatMap;
    const isStale = state.numbers?.iteration !== flatMap.iteration;
    showFacts(facts, found);
    flipped.hidden = found.flipped === 0;
    fewerFlips.replaceChildren(...fewerFlipsParts(flatMap, control));
    setText(notice, [isStale ? STALE : '', closedWords(found)].filter(Boolean).join(' '));
    notice.hidden = !notice.textContent;
    again.hidden = !isStale;
    weights.show(flatMap.weights);
    norm.show(flatMap.norm);
    // A surface without boundary has only one norm.
    norm.row.hidden = found.closedParts === found.parts;
    onModel.show(flatMap.onModel);
    onMap.show(flatMap.onMap);
    squares.value = String(flatMap.squares);
    squaresRow.hidden = flatMap.onModel !== 'checks' && flatMap.onMap !== 'checks';
    looks.hidden = state.renderer === 'none';
  });
}

/** The settings that flip fewer triangles, with a button to apply them, or to look for them. */
function fewerFlipsParts({ fewerFlips, found }: FlatMap, control: FlatMapController) {
  // No setting helps for a surface without boundary.
  if (found.flipped === 0 || found.closedParts === found.parts) return [];
  const small = (label: string, onclick: () => void) =>
    element('button.small.bordered', { onclick }, label);
  if (fewerFlips === null) {
    return [small('Look for settings that flip fewer', () => control.findFewerFlips())];
  }
  if (fewerFlips === 'searching') return [element('p.quiet', 'Trying the other settings …')];
  if (fewerFlips === 'none') {
    const words = 'No other setting flips fewer. Cut the surface open, or into parts.';
    return [element('p.quiet', words)];
  }
  const { weights, norm, flipped, mean } = fewerFlips;
  const [weight, over] = [WEIGHTS[weights][0], NORMS[norm][0]];
  const number = flipped === 0 ? 'none' : groupDigits(flipped);
  return [
    element(
      'p.quiet',
      `Weight ${weight} with the norm over ${over} flips ${number}, mean error ${ratio(mean)}.`,
    ),
    small('Use these settings', () => control.choose({ weights, norm })),
  ];
}

const LEFT_OUT = 'Faces without area, or on the same vertices as another';
const STALE = 'The model has moved since it was flattened.';

function closedWords({ parts, closedParts }: Parametrization) {
  if (closedParts === 0) return '';
  const which = parts === 1 ? 'The surface has' : `${closedParts} of ${parts} parts have`;
  return `${which} no boundary: the map folds over itself. Cut it open to flatten it.`;
}

function showFacts(list: HTMLElement, found: Parametrization) {
  const rows: [string, string, string][] = [
    ['Mean error', ratio(found.mean), 'Quasi-conformal error, weighted by area: 1 keeps angles'],
    ['Worst error', ratio(found.max), 'The greatest quasi-conformal error of a triangle'],
    ['Flipped triangles', groupDigits(found.flipped), 'Triangles that are upside down on the map'],
    ['Time', duration(1000 * found.seconds), 'Computation time in the solver'],
  ];
  if (found.parts > 1) rows.push(['Parts', groupDigits(found.parts), 'Each has its own map']);
  if (found.leftOut > 0) rows.push(['Left out', groupDigits(found.leftOut), LEFT_OUT]);
  list.replaceChildren(
    ...rows.flatMap(([name, value, title]) => [
      element('dt', { title }, name),
      element('dd.figure', value),
    ]),
  );
}

/**
 * A select element with a line that explains the chosen option.
 * @param options label and explanation of each
 */
function choice<Id extends string>(
  label: string,
  options: Record<Id, string[]>,
  choose: (id: Id) => void,
) {
  const words = element('p.quiet');
  const id = `map-${label.toLowerCase().replaceAll(' ', '-')}`;
  const entries = Object.entries(options) as [Id, string[]][];
  const select = element(
    'select',
    { id, onchange: () => choose(select.value as Id) },
    ...entries.map(([value, [name]]) => element('option', { value }, name)),
  );
  const field = element('div.field-row', element('label', { for: id }, label), select);
  return {
    row: element('div.choice-row', field, words),
    show(value: Id) {
      select.value = value;
      setText(words, options[value][1]);
      words.hidden = !words.textContent;
    },
  };
}
