/** Draws lines on the current shape: one request at a time, always for the latest state. */

import { latestOnly } from '../../store/latest-only.ts';
import { MOST_LIVE_VERTICES } from '../../store/live-shape.ts';
import type { Answer, Question } from './curvature-worker.ts';
import type { AppContext } from '../../app/context.ts';

/** @param wanted the lines to draw; null for none */
export function surfaceLines(
  { store, solver, viewport }: AppContext,
  wanted: () => Omit<Question, 'shape'> | null,
  show: (answer: Answer | null, refused: string) => void,
) {
  const worker = new Worker(new URL('./curvature-worker.ts', import.meta.url), {
    type: 'module',
    name: 'curvature',
  });
  /** Generation of the shape that the worker has; 0 if none. */
  let known = 0;
  /** The last question. */
  let asked = '';
  /** The lines drawn now. */
  let drawn: Answer | null = null;

  function draw() {
    const { points = new Float64Array(0), offsets = new Uint32Array(1), count = 0 } = drawn ?? {};
    viewport.unmeasured((view) => view.setSurfaceLines(points, offsets, count));
  }

  const ask = (question: Question): Promise<{ value?: Answer; refused?: string }> =>
    new Promise((answered) => {
      worker.onmessage = ({ data }) => answered(data);
      worker.onerror = (event) => {
        event.preventDefault();
        answered({
          refused: 'The curvature module could not be loaded. Check the network connection.',
        });
      };
      worker.postMessage(question);
    });

  async function once() {
    const { model, running } = store.get();
    const { geometry } = solver;
    const how = wanted();
    if (!how || !model || !geometry) {
      asked = '';
      drawn = null;
      return draw();
    }
    if (running && model.vertices > MOST_LIVE_VERTICES) return;
    const { generation, positions, connectivity } = geometry;
    const { faceOffsets: offsets, faceIndices: indices } = connectivity;
    const question = JSON.stringify([
      generation,
      how.draw,
      how.distance,
      [...how.vertices],
      [...how.faces],
    ]);
    if (question === asked) return;
    asked = question;
    const isNew = generation !== known;
    const { value, refused } = await ask({
      ...how,
      ...(isNew && { shape: { positions: positions.slice(), offsets, indices } }),
    });
    // A worker that refuses may not have taken the shape.
    known = value ? generation : 0;
    // Another mesh may have been opened since.
    if (store.get().model !== model || !wanted()) return;
    drawn = value ?? null;
    draw();
    show(drawn, refused ?? '');
  }

  viewport.on('ready', draw);
  const updates = latestOnly(once);
  return {
    /** Draws what has changed; during an update, once more after it. */
    update: () => updates.ask(),
  };
}
