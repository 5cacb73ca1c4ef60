/** Bars: number of types of panels, edges or nodes by tolerance. A click selects a tolerance. */

import { useState } from 'preact/hooks';
import { Choice } from '../../ui/components/fields.tsx';
import { count } from '../../ui/words.ts';
import type { BuildReport } from '../../pkg/engine/shape_up.js';
import type { Parts } from './parts.ts';

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

export function TypesCurve({ parts }: { parts: Parts }) {
  const [chosen, setChosen] = useState('');
  const built = parts.built.value;
  if (!built || built.report.product === 'paper') return null;
  const all = countedIn(built.report);
  const counted = (noun: string) => all.find((one) => one.noun === noun);
  const first = built.report.frame ? 'nodes' : 'panels';
  const shown = counted(chosen) ?? counted(first) ?? all[0];
  if (!shown) return null;
  const { noun, unit, setting, total, curve } = shown;
  const { joint } = built.words;
  const tolerance = parts.settings.value[setting];
  return (
    <div class="types-curve">
      <div class="field-row">
        <label for="parts-types">Types of</label>
        <Choice
          id="parts-types"
          value={noun}
          options={all.map((one) => [one.noun, `${one.noun}, tolerance in ${one.unit}`] as const)}
          onChoose={setChosen}
        />
      </div>
      <div class="type-bars" role="group" aria-label={`Types of ${noun} alike within`}>
        {curve.map(([at, types]) => (
          <button
            key={at}
            type="button"
            aria-label={`${count(types, 'type')} within ${at} ${unit}`}
            aria-pressed={at === tolerance}
            onClick={() => parts.change({ [setting]: at })}
          >
            <span class="column">
              <span class="bar" style={{ height: `${(100 * types) / Math.max(total, 1)}%` }} />
            </span>
            <span>{types}</span>
            <span class="quiet">{at}</span>
          </button>
        ))}
      </div>
      {joint && <p class="quiet">{joint}</p>}
    </div>
  );
}
