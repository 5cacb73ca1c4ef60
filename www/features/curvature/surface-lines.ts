/** Draws lines on the current shape: one request at a time, always for the latest state. */

import { latestOnly, MOST_LIVE_VERTICES } from '../../store/latest-only.ts';
import { again, messageOf } from '../../solver/errors.ts';
import type { Lines, LinesQuestion } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** @param wanted the lines to draw; null for none */
export function surfaceLines(
  { store, solver, jobs, viewport }: AppContext,
  wanted: () => Omit<LinesQuestion, 'shape'> | null,
  show: (answer: Lines | null, refused: string) => void,
) {
  /** Generation of the shape that the worker has; 0 if none. */
  let known = 0;
  /** The last question. */
  let asked: unknown[] = [];
  /** The lines drawn now. */
  let drawn: Lines | null = null;

  function draw() {
    const { points = new Float64Array(0), offsets = new Uint32Array(1), count = 0 } = drawn ?? {};
    viewport.unmeasured((view) => view.setSurfaceLines(points, offsets, count));
  }

  async function once() {
    const { model, running } = store.get();
    const { geometry } = solver;
    const how = wanted();
    if (!how || !model || !geometry) {
      asked = [];
      // Lines that another card draws stay.
      if (drawn) {
        drawn = null;
        draw();
      }
      return;
    }
    if (running && model.vertices > MOST_LIVE_VERTICES) return;
    const { generation, positions, connectivity } = geometry;
    const { faceOffsets: offsets, faceIndices: indices } = connectivity;
    const question = [generation, how.draw, how.distance, how.vertices, how.faces];
    if (question.every((part, i) => part === asked[i])) return;
    asked = question;
    const shape = { positions: positions.slice(), offsets, indices };
    const ask = (how: LinesQuestion) => jobs.ask.surfaceLines(how);
    let found: Lines | null = null;
    let refused = '';
    try {
      found = generation === known ? await again(() => ask(how)) : null;
      // The worker lacks the shape, or what it had was lost.
      found ??= await again(() => ask({ ...how, shape }));
    } catch (error) {
      refused = messageOf(error);
    }
    // A worker that refuses may not have taken the shape.
    known = found ? generation : 0;
    // Another mesh may have been opened since.
    if (store.get().model !== model || !wanted()) return;
    drawn = found;
    draw();
    show(drawn, refused);
  }

  viewport.on('ready', () => {
    if (drawn) draw();
  });
  const updates = latestOnly(once);
  return {
    /** Draws what has changed; during an update, once more after it. */
    update: () => updates.ask(),
  };
}
