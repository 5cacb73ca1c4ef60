/** The distance up to which a panel, or another element, is as it shall be. */

import { useApp } from '../store/use-app.ts';
import { AmountField } from '../ui/components/fields.tsx';
import { brief, writtenUnit } from '../ui/words.ts';

export function Tolerance() {
  const { store, actions } = useApp();
  const { document } = store.state;
  if (!document) return null;
  const { symbol, factor } = writtenUnit('length', document.units, document.tolerance);
  const shown = document.tolerance * factor;
  const set = (tolerance: number | null) => actions.edit({ setTolerance: { tolerance } });
  return (
    <div class="field-row tolerance">
      <label for="tolerance">Tolerance</label>
      <span class="with-unit">
        <AmountField
          id="tolerance"
          unit={symbol}
          value={shown}
          shown={brief(shown)}
          isPositive
          onAmount={(value) => set(value / factor)}
          onEmpty={() => set(null)}
        />
        <span class="quiet">{symbol}</span>
      </span>
    </div>
  );
}
