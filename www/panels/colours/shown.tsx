/** What is drawn besides the model, and the range and the map of the colours. */

import { useComputed } from '@preact/signals';
import { inLegend, shownUnit, toleranceOf } from '../../store/colours/measures.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { AmountField, Checkbox, Choice } from '../../ui/components/fields.tsx';
import { number } from '../../ui/words.ts';
import { showsFitted, type State } from '../../store/state.ts';

/** Labels of the switches, in the order of display. */
const SWITCHES = {
  edges: 'Edges',
  vertices: 'Vertices',
  shapes: 'Best-fitting shapes',
  outlines: 'Outlines of the best fit',
  arrows: 'Arrows to the best fit',
  ground: 'Ground grid',
  bands: 'Colours in bands',
  gizmo: 'Arrows at handles',
  legend: 'Legend of the colours',
  timings: 'Timings',
};

export function Shown() {
  const { store, actions } = useApp();
  const display = { ...store.state.display, shapes: showsFitted(store.state) };
  return (
    <>
      <Range />
      <div class="toggles">
        {(Object.keys(SWITCHES) as (keyof typeof SWITCHES)[]).map((key) => (
          <Checkbox
            key={key}
            label={SWITCHES[key]}
            checked={display[key]}
            onCheck={(checked) => actions.display({ [key]: checked })}
          />
        ))}
      </div>
    </>
  );
}

/** The option that colours only values beyond the tolerance. */
const BEYOND = 'beyond';
/** Id, label and tooltip of each colour map. */
const MAPS = [
  [BEYOND, 'Beyond tolerance', 'Only faces beyond the tolerance are coloured'],
  ['viridis', 'Viridis', 'All faces are coloured'],
  ['cividis', 'Cividis', 'All faces are coloured, the same with red-green blindness'],
  ['turbo', 'Turbo, not colour-blind safe', 'All faces are coloured'],
  ['diverging', 'Diverging', 'Blue within the tolerance, red beyond it'],
  ['grey', 'Grey', 'All faces in shades of grey, for print'],
] as const;

/** The range of the colours, and their map. */
function Range() {
  const { store, actions } = useApp();
  const { state } = store;
  // Each frame changes the distribution of the values, of which only this is shown here.
  const isCounted = useComputed(() => state.spread !== null).value;
  const unit = useComputed(() => shownUnit(state).symbol).value;
  const factor = useComputed(() => shownUnit(state).factor).value;
  const { range, display } = state;
  const about = inLegend(state);
  if (!about || !isCounted) return null;
  const allowed = toleranceOf(state, about);
  // Without a tolerance, the maps relative to it do not apply.
  const maps = MAPS.filter(([id]) => allowed !== null || (id !== BEYOND && id !== 'diverging'));
  const isFull = allowed === null || display.full;
  const map = maps.some(([id]) => id === display.map) ? display.map : 'viridis';
  const end = (name: 'low' | 'high') => ({
    onAmount: (value: number) => actions.setRange({ [name]: value / factor }),
    onEmpty: () => actions.setRange({ [name]: null }),
  });
  return (
    <>
      <div class="field-row">
        <span>Colours</span>
        <span class="with-unit">
          <AmountField
            name="Colours from"
            unit={about.unit === 'length' ? unit : ''}
            // Signed values have a symmetric range.
            disabled={about.signed}
            value={range[0] * factor}
            shown={number(range[0] * factor)}
            {...end('low')}
          />
          to
          <AmountField
            name="Colours to"
            unit={about.unit === 'length' ? unit : ''}
            // A range about 0 ends above it.
            isPositive={about.signed}
            value={range[1] * factor}
            shown={number(range[1] * factor)}
            {...end('high')}
          />
          <span class="quiet">{unit}</span>
        </span>
      </div>
      <div class="field-row">
        <Button
          class="bordered small"
          title="End the range at the worst face of the current shape"
          onClick={() => actions.fitRange()}
        >
          Fit range
        </Button>
        {!about.signed && (
          <Checkbox
            label="Log scale"
            title="Equal ratios have equal lengths on the scale"
            checked={display.log}
            onCheck={(log) => actions.display({ log })}
          />
        )}
      </div>
      {/* They have their own map. */}
      {!about.signed && (
        <div class="field-row">
          <label for="colour-map">Colour map</label>
          <Choice
            id="colour-map"
            value={isFull ? map : BEYOND}
            options={maps}
            onChoose={(id) =>
              actions.display(
                id === BEYOND
                  ? { full: false }
                  : { full: true, map: id as State['display']['map'] },
              )
            }
          />
        </div>
      )}
    </>
  );
}
