/**
 * The worker that makes parts, one request after another: a second instance of the engine, so that
 * iterations do not wait for it.
 */

import init, { Builder, buildOffers } from '../../pkg/engine/shape_up.js';
import { archive } from './archive.js';
import { messageOf } from '../../solver/messages.js';

/** @typedef {import("../../solver/messages.js").BuildRequest} BuildRequest */
/** @typedef {import("../../solver/messages.js").BuildReplies} BuildReplies */

/** The file name of the shape with its offset, the same as on the command line. */
const PRESENTATION = 'model.glb';

const ready = init();
/** The last build. @type {Builder | null} */
let builder = null;
/** Its input; with `isReshaped`, the positions belong to the offset only. @type {Shape | null} */
let shape = null;
let isReshaped = false;

/** @typedef {Omit<Extract<BuildRequest, { type: "build" }>, "type" | "sheets">} Shape */

/** @param {Shape} next */
function build(next) {
  const { positions, offsets, indices, settings, symbol, metres } = next;
  builder?.free();
  builder = shape = null;
  builder = new Builder(positions, offsets, indices, settings, symbol, metres);
  shape = next;
  isReshaped = false;
  return builder;
}

/** The parts of the current shape, rebuilt first if only the offset has followed it. */
function whole() {
  if (shape && isReshaped) build(shape);
  return builder;
}

/** @param {Builder} builder @returns {import("../../solver/messages.js").OffsetLayer} */
const layerOf = (builder) => ({
  points: builder.layer() ?? new Float64Array(0),
  edges: builder.failedEdges(),
  vertices: builder.failedNodes(),
  panels: builder.failedPanels(),
});

/** @type {{ [Type in keyof BuildReplies]: (request: Extract<BuildRequest, { type: Type }>) => BuildReplies[Type] | Promise<BuildReplies[Type]> }} */
const ANSWERS = {
  offers: () => buildOffers(),
  build({ sheets, ...shape }) {
    const builder = build(shape);
    return { report: builder.report(), sheets: builder.sheets(0, sheets), layer: layerOf(builder) };
  },
  moveLayer({ distance }) {
    if (!builder) return null;
    builder.moveLayer(distance);
    return { report: builder.card(), layer: layerOf(builder) };
  },
  reshape({ positions }) {
    if (!builder || !shape) return null;
    builder.reshape(positions);
    shape = { ...shape, positions };
    isReshaped = true;
    return { report: builder.card(), layer: layerOf(builder) };
  },
  numbers: () => whole()?.numbers() ?? [],
  choices: () => builder?.choices() ?? [],
  reportPage: ({ title, zUp, camera, link }) =>
    whole()?.reportPage(title, zUp, camera, link) ?? null,
  spatialParts: ({ zUp }) => whole()?.spatialParts(zUp) ?? [],
  zip({ zUp }) {
    const builder = whole();
    /** @type {{ name: string, text: string }[]} */
    const files = builder?.files(zUp) ?? [];
    /** @type {[string, Uint8Array<ArrayBuffer>][]} */
    const entries = files.map(({ name, text }) => [name, new TextEncoder().encode(text)]);
    if (builder) entries.push([PRESENTATION, new Uint8Array(builder.presentation(zUp))]);
    return archive(entries);
  },
};

/** @param {MessageEvent<{ id: number, request: BuildRequest }>} message */
onmessage = async ({ data: { id, request } }) => {
  try {
    await ready;
    const answer = /** @type {(request: BuildRequest) => unknown} */ (ANSWERS[request.type]);
    const value = await answer(request);
    postMessage({ id, value }, value instanceof Uint8Array ? [value.buffer] : []);
  } catch (error) {
    postMessage({ id, refused: messageOf(error) });
  }
};
