/** The kept shapes: a strip of thumbnails, and a table of their numbers. */

import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { LOCKED, mayKeepShapes } from '../../store/panels-card.ts';
import { useAnswerTo } from '../../store/use-answer.ts';
import { useApp } from '../../store/use-app.ts';
import { CloseButton } from '../../ui/components/buttons.tsx';
import { Thumbnail } from '../../ui/components/thumbnail.tsx';
import { areaOf, groupDigits, length } from '../../ui/words.ts';
import { keptShapes } from './kept-shapes.ts';
import type { Edit, Document as SceneDocument, VariantRow } from '../../pkg/engine/shape_up.js';
import type { Connectivity } from '../../solver/types.ts';

/** Headings and tooltips of the table. */
const COLUMNS = [
  ['', ''],
  ['Worst', 'The largest distance of a vertex from a required constraint'],
  ['Moved', 'The largest distance from the original'],
  ['Area', 'Of all faces'],
  ['Beyond', 'Panels beyond the tolerance'],
];

/** The kept shapes with their numbers, and the scene that has them. */
interface KeptShapes {
  scene: SceneDocument;
  connectivity: Connectivity;
  rows: VariantRow[];
  /** of each, `#V by 3` */
  shapes: Float64Array[];
}

export function Kept() {
  const { store } = useApp();
  const kept = useKept();
  const change = useKeptChange();
  const hasAny = (store.state.document?.variants.length ?? 0) > 0;
  return (
    <div class="kept">
      <h3>Kept</h3>
      {!hasAny && (
        <p class="quiet">The shapes that you keep appear here, to compare and to return to.</p>
      )}
      {hasAny && (
        <div class="kept-strip" role="group" aria-label="Kept">
          {kept?.rows.map((row, index) => (
            <KeptCard
              key={row.name}
              row={row}
              of={kept}
              shape={kept.shapes[index]}
              change={change}
            />
          ))}
        </div>
      )}
      {hasAny && (
        <table class="kept-table" aria-label="Kept shapes compared">
          <thead>
            <tr>
              {COLUMNS.map(([name, title]) => (
                <th key={name} scope="col" title={title}>
                  {name}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {kept?.rows.map((row) => (
              <Numbers key={row.name} row={row} scene={kept.scene} />
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

function KeptCard({
  row: { name, isCurrent, isDesign },
  of: { scene, connectivity },
  shape,
  change,
}: {
  row: VariantRow;
  of: KeptShapes;
  shape: Float64Array;
  change: ReturnType<typeof useKeptChange>;
}) {
  const { state } = useApp().store;
  const mayGo = isCurrent || mayKeepShapes(state);
  const title = isCurrent ? 'This shape is open' : `Go to ${name}`;
  const place = useRef<HTMLButtonElement>(null);
  useLayoutEffect(() => {
    if (isCurrent) place.current?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }, [isCurrent]);
  return (
    <div class="kept-card">
      <button
        ref={place}
        type="button"
        class="kept-picture"
        title={mayGo ? title : LOCKED}
        disabled={!mayGo}
        aria-current={isCurrent || undefined}
        onClick={() => change(name, (index) => ({ goToVariant: { index } }))}
      >
        <Thumbnail connectivity={connectivity} shape={shape} up={scene.up} dark={state.dark} />
        <span>{name}</span>
      </button>
      <div>
        {!isDesign && (
          <CloseButton
            label={`Remove ${name}`}
            onClick={() => change(name, (index) => ({ removeVariant: { index } }))}
          />
        )}
      </div>
    </div>
  );
}

function Numbers({ row, scene }: { row: VariantRow; scene: SceneDocument }) {
  const { name, isCurrent, distance, moved, area, panels, beyond } = row;
  const { units, tolerance } = scene;
  return (
    <tr aria-current={isCurrent || undefined}>
      <th scope="row">{name}</th>
      <td class="figure">{distance === null ? '–' : length(distance, units, tolerance)}</td>
      <td class="figure">{length(moved.max, units)}</td>
      <td class="figure">{areaOf(area, units)}</td>
      <td class="figure">
        {panels > 0 ? `${groupDigits(beyond)} of ${groupDigits(panels)}` : '–'}
      </td>
    </tr>
  );
}

/** The kept shapes, asked for again when the scene or the shape has changed. */
function useKept() {
  const { store, solver, actions } = useApp();
  const { document: scene, model, running } = store.state;
  const shapesOf = useMemo(() => keptShapes(actions.ask), [model]);
  const { answer } = useAnswerTo([scene, running], async (): Promise<KeptShapes | null> => {
    const { connectivity } = solver.geometry ?? {};
    if (!scene || !connectivity) return null;
    const rows = scene.variants.length > 0 ? await actions.ask.variantTable() : [];
    return { scene, connectivity, rows, shapes: await shapesOf(rows) };
  });
  return answer;
}

/** Changes a kept shape by its name: those that are shown may not be those of the document yet. */
function useKeptChange() {
  const { store, actions } = useApp();
  return (name: string, edit: (index: number) => Edit) => {
    const index = store.get().document?.variants.indexOf(name) ?? -1;
    if (index >= 0) void actions.editRow(name, edit(index));
  };
}
