/** Bars: number of types of panels, edges or nodes by tolerance. A click selects a tolerance. */

import { choice, setOptions } from '../../ui/controls/fields.ts';
import { element, setAttribute, setText } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import type { BuildReport, BuildSettings } from '../../solver/types.ts';

/** Elements that are sorted into types, with the number of types at each tolerance. */
type Counted = {
  noun: string;
  unit: string;
  setting: 'alike' | 'alike_deg';
  total: number;
  curve: number[][];
};

/** The elements that a build sorts into types. */
function countedIn({
  frame,
  panels,
  types_curve,
  edges,
  edge_types_curve,
}: BuildReport): Counted[] {
  const length = { unit: 'mm', setting: 'alike' } as const;
  const angle = { unit: '\u00b0', setting: 'alike_deg' } as const;
  const all: Counted[] = [
    { ...length, noun: 'panels', total: panels, curve: types_curve },
    { ...length, noun: 'edges', total: edges, curve: edge_types_curve },
  ];
  if (frame)
    all.push({ ...angle, noun: 'nodes', total: frame.nodes, curve: frame.node_types_curve });
  return all.filter(({ curve }) => curve.length > 0);
}

export function typesCurve(change: (change: Partial<BuildSettings>) => void) {
  /** The user's choice of elements. */
  let chosen = '';
  let draw = () => {};
  const what = choice({ id: 'parts-types' }, (value) => {
    chosen = value;
    draw();
  });
  const title = element(
    'div.field-row',
    element('label', { for: 'parts-types' }, 'Types of'),
    what,
  );
  const bars = element('div.type-bars', { role: 'group' });
  const joint = element('p.quiet');
  const place = element('div.types-curve', title, bars, joint);

  function showBars({ noun, unit, setting, total, curve }: Counted, settings: BuildSettings) {
    setAttribute(bars, 'aria-label', `Types of ${noun} alike within`);
    bars.replaceChildren(
      ...curve.map(([at, types]) => {
        const bar = element('span.bar');
        bar.style.height = `${(100 * types) / Math.max(total, 1)}%`;
        return element(
          'button',
          {
            'aria-label': `${count(types, 'type')} within ${at} ${unit}`,
            'aria-pressed': String(at === settings[setting]),
            onclick: () => change({ [setting]: at }),
          },
          element('span.column', bar),
          element('span', String(types)),
          element('span.quiet', String(at)),
        );
      }),
    );
  }

  return {
    place,
    /** @param said the least joint in words */
    update(report: BuildReport, said: string, settings: BuildSettings) {
      const { product, frame } = report;
      const all = countedIn(report);
      setOptions(
        what,
        all.map(({ noun, unit }) => [noun, `${noun}, tolerance in ${unit}`]),
      );
      draw = () => {
        const first = frame ? 'nodes' : 'panels';
        const shown =
          all.find(({ noun }) => noun === chosen) ??
          all.find(({ noun }) => noun === first) ??
          all[0];
        place.hidden = product === 'paper' || !shown;
        if (!shown) return;
        what.value = shown.noun;
        showBars(shown, settings);
      };
      draw();
      joint.hidden = said === '';
      setText(joint, said);
    },
  };
}
