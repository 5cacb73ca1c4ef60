/** The form of the declared settings, in their groups, and the presets of material, machine and sheet. */

import { choice } from '../../ui/controls/fields.ts';
import { declaredField, type SettingValue } from '../../ui/controls/declared-field.ts';
import { element } from '../../ui/dom.ts';
import type { BuildPreset, BuildSetting, BuildSettings } from '../../solver/types.ts';

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
  const choices = [...new Set(presets.map((preset) => preset.of))].map((of) => {
    const own = presets.filter((preset) => preset.of === of);
    const select = choice(
      { id: `parts-preset-${of.toLowerCase().replace(' ', '-')}` },
      (value) => change(own[Number(value)].values),
      [['', 'Own'], ...own.map(({ label }, k) => [String(k), label])],
    );
    const row = element('div.field-row', element('label', { for: select.id }, of), select);
    /** Shows the preset of the settings, if there is one. */
    const show = (settings: BuildSettings) => {
      const chosen = own.findIndex(({ values }) =>
        Object.entries(values).every(
          ([key, value]) =>
            JSON.stringify(settings[key as keyof BuildSettings]) === JSON.stringify(value),
        ),
      );
      select.value = chosen < 0 ? '' : String(chosen);
      select.options[0].hidden = chosen >= 0;
    };
    return { row, show };
  });
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
    form: element('div.parts-settings', make, ...choices.map(({ row }) => row), ...rows, ...folded),
    /** @param unit of the mesh */
    show(settings: BuildSettings, unit: string) {
      now = settings;
      choices.forEach((own) => own.show(settings));
      for (const { setting, row, show } of fields) {
        row.hidden = !setting.products.includes(settings.product);
        show(valueAt(settings, setting.id), unit);
      }
      folded.forEach((one, k) => (one.hidden = others[k].every(({ hidden }) => hidden)));
    },
  };
}
