/** The New mesh dialog: the kinds that the solver declares, their sizes, and the mesh in the view. */

import './new-mesh.css';
import { useEffect, useLayoutEffect, useMemo, useState } from 'preact/hooks';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { Button } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { SizeField } from '../../ui/components/size-field.tsx';
import { rounded, unitsOfLength } from '../../ui/words.ts';
import init, { newKinds, newMesh as meshOf } from '../../pkg/engine/shape_up.js';
import { metresOrOne, PLAN, roundedPlace } from './plan.ts';
import { PlanForm } from './plan-form.tsx';
import { openMesh, SPAN, SpanForm } from './span-form.tsx';
import { Trial, type Asked } from './trial.ts';
import { useKept, type Kept } from './use-kept.ts';
import type { AppContext } from '../../app/context.ts';
import type { NewKind, Size } from '../../pkg/engine/shape_up.js';

/** The unit of the defaults. */
const METRE = 'm';

/** @param first what is chosen at first; by default the first kind */
export async function newMesh(app: AppContext, first?: { id: string }) {
  const { files, solver } = app;
  await init({ module_or_path: solver.module });
  const kinds = newKinds();
  const trial = new Trial(app, await files.asItIs());
  const open = openMesh(app);
  showDialog(app, { id: 'new-mesh', title: 'New mesh', lasts: true }, ({ close }) => (
    <NewMesh {...{ close, kinds, trial, open }} first={(first ?? kinds[0]).id} />
  ));
}

function NewMesh({
  close,
  kinds,
  first,
  trial,
  open,
}: InDialog & {
  kinds: NewKind[];
  first: string;
  trial: Trial;
  open: ReturnType<typeof openMesh>;
}) {
  const [id, setId] = useState(first);
  const [unit, setUnit] = useState(METRE);
  const kept: Kept = useMemo(() => new Map(), []);
  useEffect(() => trial.begin(close), [trial]);
  const choices = [...kinds, PLAN, SPAN];
  const kind = kinds.find((one) => one.id === id);
  const label = choices.find((one) => one.id === id)?.label ?? '';
  const ask = (asked: Asked) => trial.ask(label, asked);
  return (
    <div class="dialog-body">
      <div class="which">
        <label>
          <span>Shape</span>
          <Choice
            value={id}
            options={choices.map((one) => [one.id, one.label] as const)}
            onChoose={setId}
          />
        </label>
        {/* A mesh between curves has the unit of these. */}
        {id !== SPAN.id && (
          <label>
            <span>Unit</span>
            <Choice
              value={unit}
              options={unitsOfLength().map((symbol) => [symbol, symbol] as const)}
              onChoose={setUnit}
            />
          </label>
        )}
      </div>
      <div class="form">
        {kind && <SizesForm key={id} {...{ kind, unit, kept, ask }} />}
        {id === PLAN.id && <PlanForm {...{ unit, kept, ask }} />}
        {id === SPAN.id && <SpanForm {...{ open, kept, ask }} />}
      </div>
      <footer>
        <p aria-live="polite">{trial.said.value}</p>
        <div class="dialog-buttons">
          <Button class="primary" disabled={!trial.canKeep.value} onClick={() => trial.keep(close)}>
            Create mesh
          </Button>
          <Button onClick={close}>Cancel</Button>
        </div>
      </footer>
    </div>
  );
}

/** Significant digits of the first sizes. */
const DIGITS = 4;

const isWithin = (value: number, { least, most }: Size) => value >= least && value <= most;

/** The sizes of a kind of mesh that the solver declares. */
function SizesForm({
  kind: { id, summary, sizes },
  unit,
  kept,
  ask,
}: {
  kind: NewKind;
  unit: string;
  kept: Kept;
  ask: (asked: Asked) => void;
}) {
  /** Each as it was typed, in the unit of that time: another unit changes no mesh. */
  const [typed, set] = useKept(kept, id, () =>
    sizes.map((size) => ({ value: rounded(size.default, DIGITS), of: METRE })),
  );
  const values = typed.map(({ value, of }, i) => {
    const factor = sizes[i].of === 'length' ? metresOrOne(of) / metresOrOne(unit) : 1;
    return factor * value;
  });
  /** What is wrong with what is typed for each. */
  const [problems, setProblems] = useState(sizes.map(() => ''));
  useLayoutEffect(() => {
    setProblems(problems.map((problem, i) => (isWithin(values[i], sizes[i]) ? '' : problem)));
  }, [unit]);
  useLayoutEffect(() => {
    function make() {
      const wrong = problems.findIndex(Boolean);
      if (wrong >= 0) throw new Error(`${sizes[wrong].label}: ${problems[wrong]}`);
      return { text: meshOf(id, Float64Array.from(values), unit), supports: [] };
    }
    ask({ make });
  }, [typed, problems, unit]);
  return (
    <div class="kind">
      <p class="quiet">{summary}</p>
      <div class="sizes">
        {sizes.map((size, i) => (
          <SizeField
            key={`${size.id} ${unit}`}
            size={size}
            value={typed[i].of === unit ? values[i] : roundedPlace(values[i])}
            unit={unit}
            onSize={(value, problem) => {
              if (!problem) set(typed.with(i, { value, of: unit }));
              setProblems(problems.with(i, problem));
            }}
          />
        ))}
      </div>
    </div>
  );
}
