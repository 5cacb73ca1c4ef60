/** Draws lines on the current shape: one request at a time, always for the newest state. */

/** @typedef {import("./curvature-worker.js").Question} Question */
/** @typedef {import("./curvature-worker.js").Answer} Answer */

/** Lines on larger meshes are updated only at rest. */
const MOST_LIVE_VERTICES = 3000;

/**
 * @param {import("../../app/context.js").AppContext} app
 * @param {() => Omit<Question, "shape"> | null} wanted the lines to draw; null for none
 * @param {(answer: Answer | null, refused: string) => void} show
 */
export function surfaceLines({ store, solver, viewport }, wanted, show) {
  const worker = new Worker(new URL('./curvature-worker.js', import.meta.url), {
    type: 'module',
    name: 'curvature',
  });
  let isAsking = false;
  let isStale = false;
  /** Checksums of the shape that the worker has. */
  let known = '';
  /** The last question. */
  let asked = '';
  /** The lines drawn now. @type {Answer | null} */
  let drawn = null;

  function draw() {
    const { points = new Float64Array(0), offsets = new Uint32Array(1), count = 0 } = drawn ?? {};
    viewport.unmeasured((view) => view.setSurfaceLines(points, offsets, count));
  }

  /** @param {Question} question @returns {Promise<{ value?: Answer, refused?: string }>} */
  const ask = (question) =>
    new Promise((answered) => {
      worker.onmessage = ({ data }) => answered(data);
      worker.onerror = (event) => {
        event.preventDefault();
        answered({ refused: 'The part that finds curvature could not be fetched.' });
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
    const { positions, connectivity } = geometry;
    const { faceOffsets: offsets, faceIndices: indices } = connectivity;
    const shape = `${sum(positions)} ${offsets.length} ${sum(indices)}`;
    const question = JSON.stringify([
      shape,
      how.draw,
      how.distance,
      [...how.vertices],
      [...how.faces],
    ]);
    if (question === asked) return;
    asked = question;
    const isNew = shape !== known;
    known = shape;
    const { value, refused } = await ask({
      ...how,
      ...(isNew && { shape: { positions: positions.slice(), offsets, indices } }),
    });
    // Another mesh may have been opened since.
    if (store.get().model !== model || !wanted()) return;
    drawn = value ?? null;
    draw();
    show(drawn, refused ?? '');
  }

  viewport.on('ready', draw);
  return {
    /** Draws what has changed; during an update, once more after it. */
    async update() {
      isStale = true;
      if (isAsking) return;
      isAsking = true;
      while (isStale) {
        isStale = false;
        await once();
      }
      isAsking = false;
    },
  };
}

/** A checksum that changes with the numbers. @param {Float64Array | Uint32Array} numbers */
function sum(numbers) {
  let sum = 0;
  for (let i = 0; i < numbers.length; i++) sum += numbers[i] * ((i % 7) + 1);
  return sum;
}
