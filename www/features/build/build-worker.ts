/**
 * The worker that makes parts, one request after another: a second instance of the engine, so that
 * iterations do not wait for it.
 */

import init, { Builder, buildOffers } from '../../pkg/engine/shape_up.js';
import { archive } from './archive.ts';
import {
  messageOf,
  type BuildRequest,
  type BuildReplies,
  type OffsetLayer,
} from '../../solver/messages.ts';

/** The file name of the shape with its offset, the same as on the command line. */
const PRESENTATION = 'model.glb';

const ready = init();
/** The last build. */
let builder: Builder | null = null;
/** Its input; with `isReshaped`, the positions belong to the offset only. */
let shape: Shape | null = null;
let isReshaped = false;

type Shape = Omit<Extract<BuildRequest, { type: 'build' }>, 'type' | 'sheets'>;

function build(next: Shape) {
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

const layerOf = (builder: Builder): OffsetLayer => ({
  points: builder.layer() ?? new Float64Array(0),
  edges: builder.failedEdges(),
  vertices: builder.failedNodes(),
  panels: builder.failedPanels(),
});

const ANSWERS: {
  [Type in keyof BuildReplies]: (
    request: Extract<BuildRequest, { type: Type }>,
  ) => BuildReplies[Type] | Promise<BuildReplies[Type]>;
} = {
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
    const files: { name: string; text: string }[] = builder?.files(zUp) ?? [];
    const entries: [string, Uint8Array<ArrayBuffer>][] = files.map(({ name, text }) => [
      name,
      new TextEncoder().encode(text),
    ]);
    if (builder) entries.push([PRESENTATION, new Uint8Array(builder.presentation(zUp))]);
    return archive(entries);
  },
};

onmessage = async ({
  data: { id, request },
}: MessageEvent<{ id: number; request: BuildRequest }>) => {
  try {
    await ready;
    const answer = ANSWERS[request.type] as (request: BuildRequest) => unknown;
    const value = await answer(request);
    postMessage({ id, value }, value instanceof Uint8Array ? [value.buffer] : []);
  } catch (error) {
    postMessage({ id, refused: messageOf(error) });
  }
};
