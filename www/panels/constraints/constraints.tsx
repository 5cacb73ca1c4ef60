/** The list of constraints. */

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { isInLegend } from '../../store/colours/measures.ts';
import { useApp } from '../../store/use-app.ts';
import { Icon } from '../../ui/components/buttons.tsx';
import { AmountField } from '../../ui/components/fields.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { groupDigits, length, lengthOrZero, limit } from '../../ui/words.ts';
import { valueInWords } from '../../ui/kinds/parameter-forms.ts';
import { Details } from './details.tsx';
import type { ConstraintRow, Param } from '../../pkg/engine/shape_up.js';

const NONE = new Uint32Array(0);
/** What a press opens is brought into sight only when no second one may follow it to the same place. */
const DOUBLE_CLICK_MS = 400;

export function Constraints() {
  const { document } = useApp().store.state;
  if (!document) return null;
  if (document.constraints.length === 0)
    return <p class="quiet">No constraints yet. To add one, press Add constraint.</p>;
  return (
    <ul aria-label="Constraints">
      {document.constraints.map((row) => (
        <Row key={row.number} row={row} />
      ))}
    </ul>
  );
}

function Row({ row }: { row: ConstraintRow }) {
  const { store, actions } = useApp();
  const { kinds, refused } = store.state;
  const toggle = useRef<HTMLInputElement>(null);
  // A change that was refused is taken back.
  useLayoutEffect(() => {
    if (toggle.current) toggle.current.checked = row.enabled;
  }, [refused]);
  const [isOpen, setOpen] = useState(false);
  const [isRenamed, setRenamed] = useState(false);
  const place = useRef<HTMLLIElement>(null);
  const kind = kinds.find(({ id }) => id === row.kind);
  const name = `${row.label} on ${row.on}`;
  const details = `constraint-${row.index}-details`;
  const set = (change: { weight?: number; enabled?: boolean }) =>
    actions.editRow(row.number, { setConstraint: { index: row.index, ...change } });

  const untint = () => actions.tint('pointed', null);
  useEffect(() => untint, []);
  /** Tints the members in the view. */
  async function tint() {
    const members = await actions.members(row.number);
    if (!members || !place.current?.matches(':is(:hover, :focus-within)')) return;
    // Dots on the corners of tinted faces would be redundant.
    const vertices = members.faces.length > 0 ? NONE : members.vertices;
    actions.tint('pointed', { faces: members.faces, vertices, colour: row.colour });
  }

  async function select() {
    const members = await actions.members(row.number);
    if (members) actions.select(members);
  }

  useEffect(() => {
    if (!isOpen) return undefined;
    const show = () => place.current?.scrollIntoView({ block: 'nearest' });
    const timer = setTimeout(show, DOUBLE_CLICK_MS);
    return () => clearTimeout(timer);
  }, [isOpen]);

  return (
    <li
      ref={place}
      class={`constraint${row.enabled ? '' : ' off'}`}
      data-index={row.index}
      style={{ '--chip': `rgb(${row.colour.join(' ')})` }}
      onPointerEnter={({ pointerType }) => {
        if (pointerType !== 'touch') void tint();
      }}
      onPointerLeave={untint}
      onFocusIn={tint}
      onFocusOut={untint}
    >
      <span class="chip" />
      <Name
        {...{ row, name, details, isOpen, isRenamed, setRenamed }}
        usual={kind?.label ?? ''}
        toggle={() => setOpen(!isOpen)}
      />
      <span class="buttons">
        <label class="switch">
          <input
            type="checkbox"
            role="switch"
            aria-label={`${name}: on`}
            title={row.enabled ? 'On' : 'Off'}
            checked={row.enabled}
            ref={toggle}
            onChange={({ currentTarget }) => set({ enabled: currentTarget.checked })}
          />
        </label>
      </span>
      <span class="on">
        <span>
          {row.name && `${kind?.label}, `}
          {row.on}
          {row.count > 1 && ` (${groupDigits(row.count)})`}
          {row.skipped > 0 && `, ${groupDigits(row.skipped)} skipped`}
          <Settings row={row} params={kind?.params ?? []} />
        </span>
      </span>
      <span class="measures">
        {/* What is required is not weighed against the rest. */}
        {row.require === 'soft' && (
          <label>
            weight
            <AmountField
              name={`${name}: weight`}
              value={row.weight}
              onAmount={(weight) => set({ weight })}
            />
          </label>
        )}
        <Worst row={row} />
      </span>
      <div class="details" id={details} hidden={!isOpen}>
        {isOpen && (
          <Details
            row={row}
            name={name}
            select={() => actions.begin(select())}
            rename={() => setRenamed(true)}
          />
        )}
      </div>
    </li>
  );
}

/** The button with the name of a row, which opens its details, or the field for another name. */
function Name(props: {
  row: ConstraintRow;
  /** what controls of the row are called */
  name: string;
  /** the label of the kind, which is the name if there is no other */
  usual: string;
  /** the id of the details */
  details: string;
  isOpen: boolean;
  toggle: () => void;
  isRenamed: boolean;
  setRenamed: (is: boolean) => void;
}) {
  const { row, name, usual, details, isOpen, toggle, isRenamed, setRenamed } = props;
  const { actions } = useApp();
  const opener = useRef<HTMLButtonElement>(null);
  /** Whether the focus was in the field, which is gone. */
  const returns = useRef(false);
  useLayoutEffect(() => {
    if (isRenamed || !returns.current) return;
    returns.current = false;
    opener.current?.focus();
  }, [isRenamed]);

  function finish(to: string | null, hadFocus: boolean) {
    returns.current = hadFocus;
    setRenamed(false);
    if (to === null || to === row.name) return;
    const change = { index: row.index, name: to === usual ? '' : to };
    void actions.editRow(row.number, { renameConstraint: change });
  }

  if (isRenamed) return <NameField name={row.name} usual={usual} finish={finish} />;
  return (
    <button
      type="button"
      class="name"
      ref={opener}
      aria-label={`${name}: parameters`}
      aria-expanded={isOpen}
      aria-controls={details}
      onClick={toggle}
      onDblClick={() => setRenamed(true)}
      onKeyDown={({ key }) => key === 'F2' && setRenamed(true)}
    >
      <span>{row.label}</span>
      <Icon name="chevron" />
    </button>
  );
}

/** The name as a field: Enter or leaving it accepts the name, Escape restores the old one. */
function NameField({
  name,
  usual,
  finish,
}: {
  name: string;
  usual: string;
  finish: (to: string | null, hadFocus: boolean) => void;
}) {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.select(), []);
  return (
    <input
      ref={field}
      class="rename"
      type="text"
      aria-label="Name of the constraint"
      placeholder={usual}
      defaultValue={name}
      maxLength={80}
      autocomplete="off"
      onBlur={({ currentTarget }) => finish(currentTarget.value.trim(), false)}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        event.preventDefault();
        event.stopPropagation();
        finish(event.key === 'Enter' ? event.currentTarget.value.trim() : null, true);
      }}
    />
  );
}

/**
 * The largest distance of a row from its shape, unless the legend shows it, and whether it is within
 * what is allowed.
 */
function Worst({ row }: { row: ConstraintRow }) {
  const { state } = useApp().store;
  const found = useThrottled(() => ({
    value: state.numbers?.worst[row.index],
    unmet: state.numbers?.exact?.unmet,
  }));
  const { document, model } = state;
  if (!row.enabled || found.value === undefined || !document) return null;
  const { units, tolerance } = document;
  const value = lengthOrZero(found.value, model?.size ?? 0);
  const isSoft = row.require === 'soft';
  const allowed = typeof row.require === 'object' ? row.require.within : isSoft ? tolerance : 0;
  // Of what is required there is a report: some panels may have a tolerance of their own.
  const unmet = isSoft ? undefined : found.unmet;
  const isWithin = unmet ? !unmet.includes(row.index) : value <= allowed;
  const { eased } = row;
  const others = eased && value > allowed ? `, some within ${limit(eased.within, units)}` : '';
  // The row says what it requires, and the field above the tolerance.
  const compared = isSoft
    ? `${isWithin ? 'within' : 'beyond'} tolerance`
    : isWithin
      ? `satisfied${others}`
      : 'not satisfied';
  return (
    <>
      <span
        class={`worst figure${isInLegend(state, row.measure) ? ' in-legend' : ''}`}
        title="The largest distance of a vertex from the shape of this constraint"
      >
        {`worst ${length(value, units, tolerance)}`}
      </span>
      <span class={isWithin ? 'within met' : 'within'}>{compared}</span>
    </>
  );
}

/** The requirement, and the parameters that differ from their defaults. */
function Settings({ row, params }: { row: ConstraintRow; params: Param[] }) {
  const units = useApp().store.state.document?.units ?? '';
  const changed = params.filter(
    ({ id, default: usual }) => JSON.stringify(row.params[id]) !== JSON.stringify(usual),
  );
  const words = changed.map(
    (param) => `${param.label.toLowerCase()} ${valueInWords(param, row.params[param.id], units)}`,
  );
  if (row.require === 'exact') words.unshift('exact');
  else if (row.require !== 'soft') words.unshift(`within ${limit(row.require.within, units)}`);
  return <>{words.map((one) => ` · ${one}`).join('')}</>;
}
