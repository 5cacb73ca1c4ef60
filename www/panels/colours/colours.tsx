/** What colours the faces, and the limit of a measure to which the tolerance does not apply. */

import { declared, shownUnit, toleranceOf } from '../../store/colours/measures.ts';
import { useApp } from '../../store/use-app.ts';
import { AmountField, Choice } from '../../ui/components/fields.tsx';
import { brief } from '../../ui/words.ts';

export function Colours() {
  const { store, actions } = useApp();
  const { state } = store;
  const unit = shownUnit(state);
  // A flat map has colours and controls of its own, which take precedence.
  if (state.flatMap) return null;
  const about = declared(state, state.measure);
  const allowed = about && toleranceOf(state, about);
  const options = state.measures.map(({ id, label }) => [id, label] as const);
  return (
    <>
      <div class="field-row">
        <label for="colour-by">Colour by</label>
        <Choice
          id="colour-by"
          value={state.measure ?? ''}
          options={[['', 'nothing'], ...options]}
          onChoose={(measure) => actions.colourBy(measure || null)}
        />
      </div>
      {about && !about.signed && !about.toleranced && state.model?.faces ? (
        <div class="field-row">
          <label for="limit" title="The largest value that is counted as within">
            Limit
          </label>
          <span class="with-unit">
            <AmountField
              key={about.id}
              id="limit"
              unit={about.unit === 'length' ? unit.symbol : ''}
              placeholder="none"
              value={allowed ? allowed * unit.factor : null}
              shown={allowed ? brief(allowed * unit.factor) : ''}
              isPositive
              onAmount={(value) => actions.setToleranceOf(about.id, value / unit.factor)}
              onEmpty={() => actions.setToleranceOf(about.id, null)}
            />
            <span class="quiet">{unit.symbol}</span>
          </span>
        </div>
      ) : null}
    </>
  );
}
