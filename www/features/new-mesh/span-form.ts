/** A mesh between curves of the open document: two curves, or inside a closed one. */

import { choice } from '../../ui/controls/fields.ts';
import { sizeField } from '../../ui/controls/size-field.ts';
import { element } from '../../ui/dom.ts';
import { length, number } from '../../ui/format.ts';
import { NewSpans } from '../../pkg/engine/shape_up.js';
import type { Connectivity } from '../../solver/types.ts';

/** Initial panel size, as a fraction of the longest curve. */
const PANEL = 0.05;

/** The open mesh, which provides the curves. */
interface OpenMesh {
  positions: Float64Array;
  connectivity: Connectivity;
  units: string;
  up: string;
}

export function spanForm(open: OpenMesh | null, onchange: () => void) {
  const spans = open && spansOf(open);
  const curves = spans?.curves() ?? [];
  const units = open?.units ?? '';
  const words = curves.map(({ label, length: far }) => `${label}, ${length(far, units)}`);
  const all = words.map((word, i) => [String(i), word]);
  const closed = all.filter((_, i) => curves[i].closed);
  const first = choice({}, onchange);
  const second = choice({}, onchange);
  const how = choice({}, offer, [
    ['between', 'Between two curves'],
    ['inside', 'Inside a closed curve'],
  ]);
  const longest = Math.max(0, ...curves.map(({ length: far }) => far));
  const size = sizeField(
    { label: 'Size of a panel', of: 'length', least: 1e-6 * longest, most: longest },
    { value: Number(number(PANEL * longest)), unit: units, onchange },
  );
  const to = element('label', element('span', 'To'), second);
  const sizes = element(
    'div.sizes',
    element('label', element('span', 'Made'), how),
    element('label', element('span', 'Curve'), first),
    to,
    size,
  );

  function offer() {
    const isInside = how.value === 'inside';
    fill(first, isInside ? closed : all, 0);
    fill(second, all, 1);
    to.hidden = isInside;
    onchange();
  }

  return {
    element: element(
      'div.kind',
      element(
        'p.quiet',
        'Uses the curves of the model that was open: its polylines and the boundaries of its faces.',
      ),
      curves.length > 0 ? sizes : '',
    ),
    show() {
      if (curves.length < 2) how.value = 'inside';
      offer();
    },
    made(): { text: string; supports: number[] } {
      if (!spans || curves.length === 0)
        throw new Error(
          'The model that was open has no curves. First open a file with polylines or a mesh with a boundary.',
        );
      const isInside = how.value === 'inside';
      if (!first.value) throw new Error('None of the curves is closed.');
      const panel = (size.querySelector('input') as HTMLInputElement).valueAsNumber;
      const other = isInside ? undefined : Number(second.value);
      return { text: spans.mesh(Number(first.value), other, panel), supports: [] };
    },
    /** The mesh keeps the unit of the open document. */
    convert() {},
  };
}

function spansOf({ positions, connectivity, units, up }: OpenMesh) {
  const { faceOffsets, faceIndices, curveOffsets, curveIndices } = connectivity;
  return new NewSpans(positions, faceOffsets, faceIndices, curveOffsets, curveIndices, units, up);
}

/** @param at index of the initial choice */
function fill(select: HTMLSelectElement, options: string[][], at: number) {
  const before = select.value;
  select.replaceChildren(...options.map(([value, label]) => element('option', { value }, label)));
  const known = options.some(([value]) => value === before);
  select.value = known ? before : (options[at]?.[0] ?? '');
}
