/** The kept shapes: a strip of thumbnails, and a table of their numbers. */

import { closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { groupDigits, length, number } from '../../ui/format.ts';
import { drawShape } from '../../ui/plot/thumbnail.ts';
import { newestOnly } from '../../store/newest-only.ts';
import type { SceneDocument, VariantRow } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

export function keptStrip({ store, solver, actions }: AppContext) {
  const strip = element('div.kept-strip', { role: 'group', 'aria-label': 'Kept' });
  const body = element('tbody');
  const table = element(
    'table.kept-table',
    { 'aria-label': 'Kept shapes compared' },
    element(
      'thead',
      element(
        'tr',
        ...COLUMNS.map(([name, title]) => element('th', { scope: 'col', title }, name)),
      ),
    ),
    body,
  );
  const empty = element(
    'p.quiet',
    'The shapes that you keep appear here, to compare and to return to.',
  );
  const place = element('div.kept', element('h3', 'Kept'), empty, strip, table);
  const newest = newestOnly();
  let isRemoving = false;

  /** Asks for the kept shapes and their numbers. */
  async function keptShapes() {
    const rows = await actions.ask.variantTable();
    const shapes: Float64Array[] = [];
    for (const index of rows.keys()) shapes.push(await actions.ask.variantPositions(index));
    return { rows, shapes };
  }

  async function update() {
    const { document: scene } = store.get();
    const { connectivity } = solver.geometry ?? {};
    if (!scene || !connectivity) return void newest(null);
    const { variants, units, up } = scene;
    empty.hidden = variants.length > 0;
    strip.hidden = table.hidden = variants.length === 0;
    const kept = await newest(variants.length > 0 ? keptShapes() : null);
    if (kept === null) return strip.replaceChildren();
    if (!kept) return;
    const { rows, shapes } = kept;
    const cards = rows.map((row, index) => card(scene, row, index));
    strip.replaceChildren(...cards.map(({ place }) => place));
    cards.forEach(({ canvas }, index) => drawShape(canvas, connectivity, shapes[index], { up }));
    strip.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    body.replaceChildren(...rows.map((row) => numbers(row, units, scene.tolerance)));
  }

  /**
   * Removes a shape. Until the strip is drawn anew, an index in it may be that of another shape.
   * @param scene which the strip shows
   */
  async function remove(index: number, scene: SceneDocument) {
    if (isRemoving || scene !== store.get().document) return;
    isRemoving = true;
    await actions.edit({ removeVariant: { index } });
    isRemoving = false;
  }

  function card(scene: SceneDocument, { name, isCurrent, isDesign }: VariantRow, index: number) {
    const canvas = element('canvas', { 'aria-hidden': 'true' });
    const go = element(
      'button.kept-picture',
      {
        title: isCurrent ? 'This shape is open' : `Go to ${name}`,
        onclick: () => actions.edit({ goToVariant: { index } }),
      },
      canvas,
      element('span', name),
    );
    if (isCurrent) go.setAttribute('aria-current', 'true');
    const cross = closeButton(`Remove ${name}`, () => remove(index, scene), { hidden: isDesign });
    return { canvas, place: element('div.kept-card', go, element('div', cross)) };
  }

  return { place, update: () => actions.reportErrors(update()) };
}

/** Headings and tooltips of the table. */
const COLUMNS = [
  ['', ''],
  ['Worst', 'The greatest distance of a vertex from its exact constraints'],
  ['Moved', 'The greatest distance from the model as it was opened'],
  ['Area', 'Of all faces'],
  ['Beyond', 'Panels beyond the tolerance'],
];

function numbers(
  { name, isCurrent, distance, moved, area, panels, beyond }: VariantRow,
  units: string,
  allowed: number,
) {
  const cells = [
    distance === null ? '–' : length(distance, units, allowed),
    length(moved.max, units),
    units ? `${number(area)} ${units}²` : number(area),
    panels > 0 ? `${groupDigits(beyond)} of ${groupDigits(panels)}` : '–',
  ];
  return element(
    'tr',
    isCurrent ? { 'aria-current': 'true' } : {},
    element('th', { scope: 'row' }, name),
    ...cells.map((words) => element('td.figure', words)),
  );
}
