/** The form of the declared settings, in their groups, and the presets of material and sheet. */

import { choice } from '../../ui/controls/fields.ts';
import { declaredField, type SettingValue } from '../../ui/controls/declared-field.ts';
import { element } from '../../ui/dom.ts';
import type { BuildPreset, BuildSetting, BuildSettings } from '../../solver/types.ts';

/** The settings of a preset. */
const valuesOf = ({ material, thickness, scale, sheet }: BuildPreset): Partial<BuildSettings> => ({
  material,
  thickness,
  scale,
  sheet,
});

/** The keys of a path such as `sheet[0]` or `limits.warp`. */
const keysOf = (path: string) => path.split(/[.[\]]/).filter(Boolean);

/** The value at a path. */
const valueAt = (settings: BuildSettings, path: string) =>
  keysOf(path).reduce<unknown>(
    (own, key) => (own as Record<string, unknown>)[key],
    settings,
  ) as SettingValue;

/** The setting that contains a path, with another value there. */
function changedAt(settings: BuildSettings, path: string, value: SettingValue) {
  const keys = keysOf(path);
  const last = keys.pop() as string;
  const changed = structuredClone(settings);
  const own = keys.reduce<unknown>((own, key) => (own as Record<string, unknown>)[key], changed);
  (own as Record<string, unknown>)[last] = value;
  const key = (keys[0] ?? last) as keyof BuildSettings;
  return { [key]: changed[key] } as Partial<BuildSettings>;
}

export function settingsForm(
  { presets, settings: declared }: { presets: BuildPreset[]; settings: BuildSetting[] },
  change: (change: Partial<BuildSettings>) => void,
) {
  let now: BuildSettings;
  const preset = choice(
    { id: 'parts-preset' },
    (value) => change(valuesOf(presets[Number(value)])),
    [['', 'Own settings'], ...presets.map(({ label }, k) => [String(k), label])],
  );
  const presetRow = element(
    'div.field-row',
    element('label', { for: preset.id }, 'Material'),
    preset,
  );
  // The offset has a slider that follows it.
  const fields = declared
    .filter(({ group }) => group !== 'Offset')
    .map((setting) => ({
      setting,
      ...declaredField(setting, `parts-${keysOf(setting.id).join('-')}`, (value) => {
        const changed = changedAt(now, setting.id, value);
        // The next field may be left before the scene has this one: sides of a sheet are one value.
        now = { ...now, ...changed };
        change(changed);
      }),
    }));
  const groups = [...new Set(fields.map(({ setting }) => setting.group))];
  const [[make, ...rows], ...others] = groups.map((group) =>
    fields.filter(({ setting }) => setting.group === group).map(({ row }) => row),
  );
  const folded = others.map((rows, k) =>
    element('details', element('summary', groups[k + 1]), ...rows),
  );
  return {
    form: element('div.parts-settings', make, presetRow, ...rows, ...folded),
    /** @param unit of the mesh */
    show(settings: BuildSettings, unit: string) {
      now = settings;
      const own = presets.findIndex((preset) =>
        Object.entries(valuesOf(preset)).every(
          ([key, value]) =>
            JSON.stringify(settings[key as keyof BuildSettings]) === JSON.stringify(value),
        ),
      );
      preset.value = own < 0 ? '' : String(own);
      preset.options[0].hidden = own >= 0;
      for (const { setting, row, show } of fields) {
        row.hidden = !setting.products.includes(settings.product);
        show(valueAt(settings, setting.id), unit);
      }
      folded.forEach((one, k) => (one.hidden = others[k].every(({ hidden }) => hidden)));
    },
  };
}
