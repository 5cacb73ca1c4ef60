/**
 * The form of the declared settings: what is made, the presets of material, machine and sheet, and what
 * else can be set, folded in groups.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { AmountField, Checkbox, Choice } from '../../ui/components/fields.tsx';
import { TextField } from '../../ui/components/text-field.tsx';
import { SeamsField } from './seams-field.tsx';
import type { BuildPreset, BuildSetting } from '../../pkg/engine/shape_up.js';
import type { BuildSettings } from '../../solver/types.ts';
import type { Edge } from './seams.ts';
import type { Parts } from './parts.ts';

/** A value of a setting, as in a scene. */
type Value = number | string | boolean | Edge[] | null;

/** The keys of a path such as `sheet[0]` or `limits.warp`. */
const keysOf = (path: string) => path.split(/[.[\]]/).filter(Boolean);

/** The id of the field of a setting. */
const idOf = (path: string) => `parts-${keysOf(path).join('-')}`;

/** What is inside of an object or a list. */
const inside = (outer: unknown, key: string) => (outer as Record<string, unknown>)[key];

export function Settings({
  parts,
  offers: { presets, settings: declared },
}: {
  parts: Parts;
  offers: { presets: BuildPreset[]; settings: BuildSetting[] };
}) {
  const form = useRef<HTMLDivElement>(null);
  useEffect(() => form.current?.querySelector('select')?.focus(), []);
  const settings = parts.settings.value;
  const unit = parts.live.unit().symbol;
  // The offset has a slider that follows it.
  const fields = declared.filter(
    ({ group, products }) => group !== 'Offset' && products.includes(settings.product),
  );
  const groups = [...new Set(fields.map(({ group }) => group))];
  const rowsOf = (group: string) =>
    fields
      .filter((setting) => setting.group === group)
      .map((setting) => (
        <Field
          key={setting.id}
          setting={setting}
          value={keysOf(setting.id).reduce<unknown>(inside, settings) as Value}
          unit={unit}
          onValue={(value) => parts.change({ [setting.id]: value })}
        />
      ));
  const [first, ...folded] = groups;
  /** Unfolds and focuses the first field of some settings. */
  function show(keys: string[]) {
    const setting = fields.find(({ id }) => keys.includes(keysOf(id)[0]));
    const field = setting && form.current?.querySelector<HTMLElement>(`#${idOf(setting.id)}`);
    field?.closest('details')?.setAttribute('open', '');
    field?.focus();
  }
  return (
    <div class="parts-settings" ref={form}>
      {rowsOf(first)}
      {[...new Set(presets.map((preset) => preset.of))].map((of) => (
        <Preset
          key={of}
          of={of}
          presets={presets.filter((preset) => preset.of === of)}
          settings={settings}
          used={(key) => fields.some(({ id }) => keysOf(id)[0] === key)}
          onChoose={(values) => parts.change(values)}
          onOwn={show}
        />
      ))}
      {folded.map((group) => (
        <details key={group}>
          <summary>{group}</summary>
          {rowsOf(group)}
        </details>
      ))}
    </div>
  );
}

/** The choice of values of one's own instead of a preset. */
const OWN = 'own';

/** The choice among presets, of which the settings may be one. */
function Preset({
  of,
  presets,
  settings,
  used,
  onChoose,
  onOwn,
}: {
  of: string;
  presets: BuildPreset[];
  settings: BuildSettings;
  /** whether a setting is one of what is made */
  used: (key: string) => boolean;
  onChoose: (values: Partial<BuildSettings>) => void;
  /** is called with the keys of the settings that presets set */
  onOwn: (keys: string[]) => void;
}) {
  /** The settings for which values of one's own were chosen. */
  const [own, setOwn] = useState<BuildSettings | null>(null);
  const isOwn = own === settings;
  const id = `parts-preset-${of.toLowerCase().replace(' ', '-')}`;
  const chosen = presets.findIndex(({ values }) =>
    Object.entries(values).every(
      ([key, value]) =>
        !used(key) || JSON.stringify(inside(settings, key)) === JSON.stringify(value),
    ),
  );
  const options = presets.map(({ label }, k) => [String(k), label] as const);
  function choose(value: string) {
    setOwn(value === OWN ? settings : null);
    if (value === OWN) onOwn(Object.keys(presets[0].values));
    else onChoose(presets[Number(value)].values);
  }
  return (
    <div class="field-row">
      <label for={id}>{of}</label>
      <Choice
        id={id}
        value={isOwn || chosen < 0 ? OWN : String(chosen)}
        options={[...options, [OWN, 'Your own']]}
        onChoose={choose}
      />
    </div>
  );
}

/** A row for a declared setting: its name, the control for its values, and its unit. */
function Field({
  setting: { id: path, label, summary: title, form, absent },
  value,
  unit,
  onValue,
}: {
  setting: BuildSetting;
  value: Value;
  /** of the mesh */
  unit: string;
  onValue: (value: Value) => Promise<unknown>;
}) {
  const id = idOf(path);
  if (form.type === 'switch')
    return <Checkbox title={title} label={label} checked={value === true} onCheck={onValue} />;
  if (form.type === 'edges')
    return <SeamsField title={title} label={label} edges={value as Edge[]} onEdges={onValue} />;
  const symbol =
    form.type === 'number' ? { '': '', mesh: unit, mm: 'mm', degrees: '°' }[form.unit] : '';
  return (
    <div class="field-row" title={title}>
      <label for={id}>
        {label}
        {symbol && <span class="visually-hidden">, {symbol}</span>}
      </label>
      {form.type === 'choice' && (
        <Choice
          id={id}
          value={String(value ?? '')}
          options={[
            ...(absent ? [['', absent] as const] : []),
            ...form.options.map((one) => [one.word, one.label, one.summary] as const),
          ]}
          onChoose={(word) => onValue(word || null)}
        />
      )}
      {form.type === 'text' && <TextField id={id} value={String(value ?? '')} onText={onValue} />}
      {form.type === 'number' && (
        <>
          <AmountField
            id={id}
            min={form.range[0]}
            max={form.range[1]}
            unit={{ '': '', mesh: unit, mm: 'mm', degrees: '' }[form.unit]}
            step={form.unit === 'degrees' ? 1 : undefined}
            placeholder={absent && 'auto'}
            value={typeof value === 'number' ? value : null}
            onAmount={onValue}
            onEmpty={absent ? () => onValue(null) : undefined}
          />
          <span class="unit" aria-hidden="true">
            {symbol}
          </span>
        </>
      )}
    </div>
  );
}
