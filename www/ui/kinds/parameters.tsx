/** Controls for the parameters of a kind, made from their declaration: forms and their fields. */

import { Fragment } from 'preact';
import { useLayoutEffect, useState } from 'preact/hooks';
import { Choice } from '../components/fields.tsx';
import { NumberInput, readNumber, type Accepted } from '../components/number-input.tsx';
import { firstIn } from '../components/number-steps.ts';
import { useEntered } from '../components/use-entered.ts';
import { useTyped } from '../components/use-typed.ts';
import {
  AXES,
  FIELD_NAMES,
  axis,
  converted,
  keyOf,
  keyOfValue,
  labelOf,
  unitOf,
  type Frame,
} from './parameter-forms.ts';
import { rounded } from '../words.ts';
import type { Param, ParamValue } from '../../pkg/engine/shape_up.js';
import type { Refusal } from './parameter-refusal.ts';

/** A unit of numbers, and what they are multiplied by to be shown in it. */
type WrittenUnit = { symbol: string; factor: number; isLength: boolean };
const PLAIN: WrittenUnit = { symbol: '', factor: 1, isLength: false };
/** Digits of a number that is shown in another unit. */
const DIGITS = 12;

/** The parameters of one kind as rows of controls; nothing for a kind without parameters. */
export function Parameters({
  params,
  values,
  frame,
  name = '',
  unit = PLAIN,
  refusal = null,
  onValue,
}: {
  params: Param[];
  /** missing ones have their default */
  values: Record<string, ParamValue>;
  /** as it is now */
  frame: Frame;
  /** prefixes the accessible names of the controls */
  name?: string;
  /** in which numbers that declare no unit of their own are shown and entered */
  unit?: WrittenUnit;
  /** shown at its parameter until that is edited */
  refusal?: Refusal | null;
  /**
   * called with a value that is entered, unless a field of it is invalid; the value is shown until the
   * edit that it returns has settled
   */
  onValue: (id: string, value: ParamValue) => unknown;
}) {
  if (params.length === 0) return null;
  const prefix = name && `${name}: `;
  return (
    <div class="parameters">
      {params.map((param) => (
        <Parameter
          key={param.id}
          param={param}
          name={`${prefix}${param.label}`}
          value={param.id in values ? values[param.id] : param.default}
          frame={frame}
          usualUnit={unit}
          refusal={refusal?.id === param.id ? refusal : null}
          onValue={(value) => onValue(param.id, value)}
        />
      ))}
      <Problem message={refusal?.id === '' ? refusal.message : ''} />
    </div>
  );
}

function Problem({ id, message }: { id?: string; message: string }) {
  return (
    <p class="error" aria-live="polite" id={id} hidden={message === ''}>
      {message}
    </p>
  );
}

interface Of {
  param: Param;
  /** its accessible name */
  name: string;
  value: ParamValue;
  onValue: (value: ParamValue) => unknown;
}

/** What has been typed and is not entered yet. */
interface Typed {
  /** per field; undefined for those that were left alone */
  texts: (string | undefined)[];
  /** what is wrong with them */
  problems: (string | undefined)[];
}
const NOTHING: Typed = { texts: [], problems: [] };

/** Number of rows made so far. */
let made = 0;

/** The row of one parameter. */
function Parameter({
  param,
  name,
  value: settledValue,
  frame,
  usualUnit,
  refusal,
  onValue,
}: Of & { frame: Frame; usualUnit: WrittenUnit; refusal: Refusal | null }) {
  const [{ texts, problems }, setTyped] = useTyped(NOTHING);
  const { over, enter } = useEntered<ParamValue>();
  const value = over(settledValue);
  const report = (to: ParamValue) => enter(to, onValue(to));
  /** The refusal after which a field was edited. */
  const [settled, setSettled] = useState<Refusal | null>(null);
  // What was typed over another value is out of date.
  useLayoutEffect(() => setTyped(NOTHING), [String(value)]);
  const key = keyOfValue(value);
  const numbers = Array.isArray(value) ? value : typeof value === 'number' ? [value] : [];
  const isVector = key === 'vector';
  const own = unitOf(param, frame.units);
  const { symbol, factor, isLength } =
    own || isVector ? { symbol: own, factor: 1, isLength: param.unit === 'length' } : usualUnit;
  const unit = isVector || numbers.length === 0 ? '' : symbol;
  const shown = numbers.map((number) =>
    number === null || factor === 1 ? number : rounded(factor * number, DIGITS),
  );
  // `useId` counts anew in each root, and dialogs are roots of their own.
  const [error] = useState(() => `parameter-problem-${++made}`);

  const [min, max] = isVector ? [] : param.range;
  /** What a number may be; a null is an infinite limit. */
  const accepted = (at: number): Accepted => ({
    unit: isLength ? symbol : '',
    step: param.unit === 'degrees' ? 1 : isVector ? firstIn('') : undefined,
    min: factor * (min ?? -Infinity),
    max: factor * (max ?? Infinity),
    present: shown[at],
  });

  const wrong = problems.findIndex(Boolean);
  const refused = refusal === settled ? null : refusal;
  const refusedPlace = refused && (refused.place < numbers.length ? refused.place : 0);
  const place = wrong >= 0 ? wrong : refusedPlace;

  function type(at: number, field: HTMLInputElement) {
    setTyped({
      texts: numbers.map((_, i) => (i === at ? field.value : texts[i])),
      // An error that appears on blur would move the page under the pointer that leaves the field
      // for a button.
      problems: numbers.map((_, i) => (i === at ? field.validationMessage : problems[i])),
    });
    setSettled(refusal);
  }

  function change(at: number, field: HTMLInputElement) {
    type(at, field);
    if (!field.validity.valid || problems.some((problem, i) => i !== at && problem)) return;
    const entered = numbers.map((number, i) => {
      const text = i === at ? field.value : texts[i];
      if (text === undefined) return number;
      const [read] = readNumber(text, accepted(i));
      return read === null ? null : read / factor;
    });
    setTyped(NOTHING);
    report((entered.length === 1 ? entered[0] : entered) as ParamValue);
  }

  return (
    <div class="parameter" role="group" aria-label={name}>
      <span class="label">{param.label}</span>
      {param.forms.length > 1 && (
        <Choice
          aria-label={`${name}: kind of value`}
          value={key}
          options={param.forms.map((form) => [keyOf(form), labelOf(param, form)] as const)}
          onChoose={(chosen) => {
            const form = param.forms.find((one) => keyOf(one) === chosen);
            setSettled(refusal);
            if (form) report(converted(param, form, value, frame));
          }}
        />
      )}
      <span class={`fields ${key.split(' ')[0]}`}>
        {isVector && <Axes name={name} value={value} onValue={report} />}
        {shown.map((number, i) => (
          <Fragment key={i}>
            {key === 'range' && i === 1 && '–'}
            <NumberInput
              accepted={accepted(i)}
              placeholder={key === 'range' ? 'no limit' : ''}
              required={key !== 'range'}
              value={texts[i] ?? (number === null ? '' : String(number))}
              aria-label={name + FIELD_NAMES[key][i]}
              aria-describedby={error}
              aria-invalid={i === place ? 'true' : undefined}
              onInput={({ currentTarget }) => type(i, currentTarget)}
              onChange={({ currentTarget }) => change(i, currentTarget)}
            />
          </Fragment>
        ))}
        {unit && <span class="quiet">{unit}</span>}
      </span>
      <Problem id={error} message={(wrong >= 0 ? problems[wrong] : refused?.message) ?? ''} />
    </div>
  );
}

/** The buttons for the directions of the axes. */
function Axes({ name, value, onValue }: Omit<Of, 'param'>) {
  const vector = Array.isArray(value) ? value : [];
  return (
    <span class="segmented">
      {AXES.map((along) => (
        <button
          key={along}
          type="button"
          aria-label={`${name} along ${along.toUpperCase()}`}
          aria-pressed={axis(along).every((part, i) => part === vector[i])}
          onClick={() => onValue(axis(along))}
        >
          {along.toUpperCase()}
        </button>
      ))}
    </span>
  );
}
