/** The flat map in its step: its errors, its settings, and the look of the two surfaces. */

import { Fragment } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { useStaleMap } from '../../store/stale-map.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { duration, groupDigits, ratio } from '../../ui/words.ts';
import { reveal } from '../../ui/reveal.ts';
import { flatMaps } from './flat-maps.ts';
import type { FlatMap } from '../../store/state.ts';
import type { FlatMap as Parametrization } from '../../pkg/engine/shape_up.js';

/** Label and explanation of each polygon weight. */
const WEIGHTS = {
  'inverse-area': ['Equal', 'A small polygon counts as much as a large one.'],
  one: ['By size', 'Large polygons count more than small ones.'],
  lscm: ['Least squares', 'On triangles, this is the least-squares conformal map.'],
};
/** Norms that keep the map from shrinking: label and explanation. */
const NORMS = {
  boundary: ['Boundary', 'The boundary is kept from shrinking; the inside follows.'],
  vertices: ['Vertices', 'All vertices are kept from shrinking, each equally.'],
};
const LOOKS = { checks: ['Checkerboard'], errors: ['Angle distortion'] };
const SQUARES = { min: 8, max: 96, step: 4 };
const STALE = 'The model has moved since it was flattened.';

export function FlatMapPanel() {
  const { flatMap } = useApp().store.state;
  return flatMap && <Panel flatMap={flatMap} />;
}

type Of = { flatMap: FlatMap };

function Panel({ flatMap }: Of) {
  const app = useApp();
  const { state } = app.store;
  const { renderer } = state;
  const maps = flatMaps(app);
  const place = useRef<HTMLElement>(null);
  // It appears above the scroll position, in a step that may be closed.
  useEffect(() => {
    if (place.current) reveal(place.current);
  }, []);
  const { found, weights, norm, onModel, onMap, squares } = flatMap;
  const isStale = useStaleMap();
  const notice = [isStale ? STALE : '', closedWords(found)].filter(Boolean).join(' ');
  return (
    <section id="flat-map-section" ref={place} aria-labelledby="heading-flat-map">
      <div class="heading-row">
        <h2 id="heading-flat-map">Flat map</h2>
        <Button class="small" title="Esc" onClick={() => maps.close()}>
          Back to the model
        </Button>
      </div>
      <Facts {...found} />
      {found.flipped > 0 && <Flipped flatMap={flatMap} />}
      {notice && <p class="notice">{notice}</p>}
      {isStale && (
        <Button class="small" onClick={() => maps.flatten()}>
          Flatten again
        </Button>
      )}
      <Option
        label="Weight of a polygon"
        value={weights}
        of={WEIGHTS}
        choose={(weights) => maps.choose({ weights })}
      />
      {/* A surface without boundary has only one norm. */}
      {!isClosed(found) && (
        <Option
          label="Keep from shrinking"
          value={norm}
          of={NORMS}
          choose={(norm) => maps.choose({ norm })}
        />
      )}
      {renderer !== 'none' && (
        <div>
          <Option
            label="On the model"
            value={onModel}
            of={LOOKS}
            choose={(onModel) => maps.choose({ onModel })}
          />
          <Option
            label="On the map"
            value={onMap}
            of={LOOKS}
            choose={(onMap) => maps.choose({ onMap })}
          />
          {[onModel, onMap].includes('checks') && (
            <div class="field-row">
              <label for="map-squares">Squares</label>
              <input
                type="range"
                id="map-squares"
                {...SQUARES}
                value={squares}
                onInput={({ currentTarget }) =>
                  maps.choose({ squares: currentTarget.valueAsNumber })
                }
              />
            </div>
          )}
        </div>
      )}
    </section>
  );
}

function Facts({ mean, max, flipped, seconds, parts, leftOut }: Parametrization) {
  const rows: [string, string, string][] = [
    [
      'Mean distortion',
      ratio(mean),
      'Of the angles, weighted by area: 1 is none (quasi-conformal)',
    ],
    ['Largest distortion', ratio(max), 'Of the angles of a triangle: 1 is none (quasi-conformal)'],
    ['Flipped triangles', groupDigits(flipped), 'Triangles that are upside down on the map'],
    ['Time', duration(1000 * seconds), 'Computation time in the solver'],
  ];
  if (parts > 1) rows.push(['Parts', groupDigits(parts), 'Each has its own map']);
  if (leftOut > 0) {
    const why = 'Faces without area, or on the same vertices as another';
    rows.push(['Left out', groupDigits(leftOut), why]);
  }
  return (
    <dl class="facts">
      {rows.map(([name, value, title]) => (
        <Fragment key={name}>
          <dt title={title}>{name}</dt>
          <dd class="figure">{value}</dd>
        </Fragment>
      ))}
    </dl>
  );
}

/** What to do about triangles that are upside down. */
function Flipped({ flatMap }: Of) {
  const maps = flatMaps(useApp());
  return (
    <div class="flipped-row">
      <p class="quiet">Outlined in red where the map folds over itself.</p>
      <Button
        title="Selects them on the model, and zooms to them in both pictures"
        onClick={() => maps.showFlipped()}
      >
        Show flipped faces
      </Button>
      <div aria-live="polite">
        {/* No setting helps for a surface without boundary. */}
        {!isClosed(flatMap.found) && <FewerFlips {...flatMap} />}
      </div>
    </div>
  );
}

/** The settings that flip fewer triangles, with a button to apply them, or to look for them. */
function FewerFlips({ fewerFlips }: FlatMap) {
  const maps = flatMaps(useApp());
  if (fewerFlips === null)
    return (
      <Button class="small bordered" onClick={() => maps.findFewerFlips()}>
        Look for settings that flip fewer
      </Button>
    );
  if (fewerFlips === 'searching') return <p class="quiet">Trying the other settings …</p>;
  if (fewerFlips === 'none')
    return (
      <p class="quiet">
        No other setting flips fewer. Cut the surface open, or into parts, in the program that made
        it.
      </p>
    );
  const { weights, norm, flipped, mean } = fewerFlips;
  const number = flipped === 0 ? 'none' : groupDigits(flipped);
  return (
    <>
      <p class="quiet">
        {`With “${WEIGHTS[weights][0]}” and “${NORMS[norm][0]}” it flips ${number}, mean distortion ${ratio(mean)}.`}
      </p>
      <Button class="small bordered" onClick={() => maps.choose({ weights, norm })}>
        Use these settings
      </Button>
    </>
  );
}

const isClosed = ({ parts, closedParts }: Parametrization) => closedParts === parts;

function closedWords({ parts, closedParts }: Parametrization) {
  if (closedParts === 0) return '';
  const which =
    parts === 1
      ? 'The surface has'
      : `${closedParts} of ${parts} parts ${closedParts === 1 ? 'has' : 'have'}`;
  return `${which} no boundary: the map folds over itself. To flatten it, cut it open in the program that made it.`;
}

/** A choice, with a line that explains what is chosen. */
function Option<Id extends string>({
  label,
  value,
  of,
  choose,
}: {
  label: string;
  value: Id;
  /** label and explanation of each */
  of: Record<Id, string[]>;
  choose: (id: Id) => void;
}) {
  const id = `map-${label.toLowerCase().replaceAll(' ', '-')}`;
  const entries = Object.entries(of) as [Id, string[]][];
  const [, words] = of[value];
  return (
    <div class="choice-row">
      <div class="field-row">
        <label for={id}>{label}</label>
        <Choice
          id={id}
          value={value}
          options={entries.map(([id, [name]]) => [id, name] as const)}
          onChoose={(chosen) => choose(chosen as Id)}
        />
      </div>
      {words && <p class="quiet">{words}</p>}
    </div>
  );
}
