/**
 * The details of a constraint in its row: drawing, requirement and parameters. Changes act at once.
 */

import '../../ui/styles/lists.css';
import { frameOf } from '../../store/frame.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { AmountField, Choice } from '../../ui/components/fields.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import {
  count,
  energyOrZero,
  length as lengthText,
  part,
  rounded,
  writtenUnit,
} from '../../ui/words.ts';
import { Drawing } from '../../ui/kinds/drawing.tsx';
import { useRefusal } from '../../ui/kinds/parameter-refusal.ts';
import { Parameters } from '../../ui/kinds/parameters.tsx';
import type { ConstraintRow, KindWords, Require } from '../../pkg/engine/shape_up.js';

interface Of {
  row: ConstraintRow;
  /** what controls of the row are called */
  name: string;
}

export function Details({
  row,
  name,
  select,
  rename,
}: Of & { select: () => unknown; rename: () => void }) {
  const { store, actions } = useApp();
  const { kinds, document } = store.state;
  const kind = kinds.find(({ id }) => id === row.kind);
  if (!kind) return null;
  const { eased, number, index } = row;
  const remove = () => actions.editRow(number, { removeConstraint: { index } });
  const duplicate = () => actions.editRow(number, { duplicateConstraint: { index } });
  return (
    <>
      <Drawing of={kind.sketch} />
      <p class="quiet">{kind.summary}</p>
      <Requirement row={row} name={name} />
      {eased && (
        <p class="quiet">
          {count(eased.panels, 'panel has', 'panels have')} a relaxed tolerance of{' '}
          {lengthText(eased.within, document?.units ?? '')}.
        </p>
      )}
      <ParameterRows row={row} name={name} kind={kind} />
      <Share row={row} />
      <div class="row-buttons">
        <Button onClick={select} aria-label={`${name}: select what it acts on`}>
          Select
        </Button>
        <Button onClick={duplicate} aria-label={`${name}: duplicate`}>
          Duplicate
        </Button>
        <Button onClick={rename} aria-label={`${name}: rename`}>
          Rename
        </Button>
        <Button onClick={remove} aria-label={`${name}: remove`}>
          Remove
        </Button>
      </div>
    </>
  );
}

function ParameterRows({ row, name, kind }: Of & { kind: KindWords }) {
  const { store, actions } = useApp();
  const { refusal, refuse, forget } = useRefusal(kind.params);
  return (
    <Parameters
      params={kind.params}
      values={row.params}
      frame={frameOf(store.state)}
      name={name}
      refusal={refusal}
      onValue={(id, value) => {
        forget();
        const change = { index: row.index, params: { [id]: value } };
        return actions.editRow(row.number, { setConstraint: change }, refuse);
      }}
    />
  );
}

/** The requirements: id, label, meaning. */
const OPTIONS = [
  ['soft', 'Soft', 'Weighed against the other constraints'],
  ['within', 'Within', 'No vertex may be farther from the shape than this length'],
  ['exact', 'Exact', 'Satisfied exactly. Soft constraints are then satisfied as well as possible.'],
] as const;

/** The requirement of a constraint: soft, within a length, or exact. */
function Requirement({ row, name }: Of) {
  const { store, actions } = useApp();
  const { document } = store.state;
  const tolerance = document?.tolerance ?? 0;
  const isTooLarge = Boolean(document?.tooLargeForExact);
  const { require } = row;
  const length = typeof require === 'object' ? require.within : tolerance;
  const { symbol, factor } = writtenUnit('length', document?.units ?? '', length);
  const required = typeof require === 'object' ? 'within' : require;
  const ask = (asked: Require) => actions.exact.require(row, asked);
  return (
    <label class="requirement">
      Required
      <Choice
        aria-label={`${name}: required`}
        title={OPTIONS.find(([id]) => id === required)?.[2]}
        value={required}
        options={OPTIONS}
        isDisabled={(id) => isTooLarge && id === 'exact' && required !== 'exact'}
        onChoose={(value) => ask(value === 'within' ? { within: tolerance } : (value as Require))}
      />
      {required === 'within' && (
        <>
          <AmountField
            name={`${name}: within`}
            unit={symbol}
            isPositive
            value={rounded(length * factor, 6)}
            onAmount={(value) => ask({ within: value / factor })}
          />
          <span>{symbol}</span>
        </>
      )}
      {isTooLarge && <small>The mesh is too large for Exact. Within is possible.</small>}
    </label>
  );
}

/** The share of a row in the energy. */
function Share({ row }: { row: ConstraintRow }) {
  const { state } = useApp().store;
  const numbers = useThrottled(() => state.numbers);
  const total = energyOrZero(numbers?.energy.total ?? 0, state.model?.size ?? 0);
  // A row that was just added has none.
  const share = numbers?.shares[row.index];
  if (!row.enabled || share === undefined || total <= 0) return null;
  return <p class="quiet figure">{part(share)} of the total energy</p>;
}
