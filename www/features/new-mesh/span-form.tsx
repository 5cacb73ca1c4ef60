/** A mesh between curves of the model that was open: two curves, or inside a closed one. */

import { useLayoutEffect, useMemo, useState } from 'preact/hooks';
import { Choice } from '../../ui/components/fields.tsx';
import { SizeField } from '../../ui/components/size-field.tsx';
import { length, rounded } from '../../ui/words.ts';
import { NewSpans } from '../../pkg/engine/shape_up.js';
import { useKept, type Kept } from './use-kept.ts';
import type { AppContext } from '../../app/context.ts';
import type { Asked } from './trial.ts';

/** The choice of curves, which is no kind of the solver. */
export const SPAN = { id: 'span', label: 'Between curves' };

/** Initial panel size, as a fraction of the longest curve. */
const PANEL = 0.05;
const NO_CURVES =
  'The model that was open has no curves. First open a file with polylines or a mesh with a boundary.';

/** The open mesh, whose curves the form uses; null if none is open. */
export function openMesh({ store, solver }: AppContext) {
  const { document: scene } = store.get();
  const { geometry } = solver;
  if (!scene || !geometry) return null;
  const { positions, connectivity } = geometry;
  return { positions: positions.slice(), connectivity, units: scene.units, up: scene.up };
}
type OpenMesh = ReturnType<typeof openMesh>;

function spansOf(open: OpenMesh) {
  if (!open) return null;
  const { positions, connectivity, units, up } = open;
  const { faceOffsets, faceIndices, curveOffsets, curveIndices } = connectivity;
  return new NewSpans(positions, faceOffsets, faceIndices, curveOffsets, curveIndices, units, up);
}

export function SpanForm({
  open,
  kept,
  ask,
}: {
  open: OpenMesh;
  kept: Kept;
  ask: (asked: Asked) => void;
}) {
  const spans = useMemo(() => spansOf(open), [open]);
  const curves = useMemo(() => spans?.curves() ?? [], [spans]);
  const units = open?.units ?? '';
  const longest = Math.max(0, ...curves.map((curve) => curve.length));
  const [chosen, choose] = useKept(kept, SPAN.id, () => ({
    isInside: curves.length < 2,
    first: '',
    second: '',
    panel: rounded(PANEL * longest, 3),
  }));
  /** What is wrong with what is typed. */
  const [problem, setProblem] = useState('');
  const { isInside, panel } = chosen;

  const all = curves.map(
    ({ label, length: far }, i) => [String(i), `${label}, ${length(far, units)}`] as const,
  );
  const closed = all.filter((_, i) => curves[i].closed);
  const firsts = isInside ? closed : all;
  const valueIn = (options: typeof all, value: string, at: number) =>
    (options.find(([one]) => one === value) ?? options[at] ?? [''])[0];
  const first = valueIn(firsts, chosen.first, 0);
  const second = valueIn(all, chosen.second, 1);

  useLayoutEffect(() => {
    function make() {
      if (!spans || curves.length === 0) throw new Error(NO_CURVES);
      if (problem) throw new Error(problem);
      if (first === '') throw new Error('None of the curves is closed.');
      const other = isInside ? undefined : Number(second);
      return { text: spans.mesh(Number(first), other, panel), supports: [] };
    }
    ask({ make });
  }, [isInside, first, second, panel, problem]);

  const label = 'Size of a panel';
  return (
    <div class="kind">
      <p class="quiet">
        Uses the curves of the model that was open: its polylines and the boundaries of its faces.
      </p>
      {curves.length > 0 && (
        <div class="sizes">
          <label>
            <span>Made</span>
            <Choice
              value={isInside ? 'inside' : 'between'}
              options={[
                ['between', 'Between two curves'],
                ['inside', 'Inside a closed curve'],
              ]}
              onChoose={(how) => choose({ ...chosen, isInside: how === 'inside' })}
            />
          </label>
          <label>
            <span>Curve</span>
            <Choice
              value={first}
              options={firsts}
              onChoose={(value) => choose({ ...chosen, first: value })}
            />
          </label>
          {!isInside && (
            <label>
              <span>To</span>
              <Choice
                value={second}
                options={all}
                onChoose={(value) => choose({ ...chosen, second: value })}
              />
            </label>
          )}
          <SizeField
            size={{ label, of: 'length', least: 1e-6 * longest, most: longest }}
            value={panel}
            unit={units}
            onSize={(panel, problem) => {
              choose({ ...chosen, panel });
              setProblem(problem && `${label}: ${problem}`);
            }}
          />
        </div>
      )}
    </div>
  );
}
