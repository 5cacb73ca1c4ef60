/**
 * The worker that makes parts, one call after another: a second instance of the engine, so that
 * iterations do not wait for it.
 */

import init, { Builder, buildOffers } from '../../pkg/engine/shape_up.js';
import { archive } from './archive.ts';
import { messageOf } from '../../solver/errors.ts';
import type { Call } from '../../solver/remote.ts';
import type { BuildSettings, OffsetLayer } from '../../solver/types.ts';

/** The file name of the shape with its offset, the same as on the command line. */
const PRESENTATION = 'model.glb';

/** A shape (positions `#V by 3`) in a unit of `metres` metres, and what is to be made of it. */
export interface Shape {
  positions: Float64Array;
  offsets: Uint32Array;
  indices: Uint32Array;
  settings: BuildSettings;
  symbol: string;
  metres: number;
}

const ready = init();
/** The last build. */
let builder: Builder | null = null;
/** Its input; with `isReshaped`, the positions belong to the offset only. */
let shape: Shape | null = null;
let isReshaped = false;

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

/** What the page may call. All but `offers` and `build` are about the last build. */
const methods = {
  /** The presets and the defaults. */
  offers: () => buildOffers(),
  /** Makes the parts of a shape, and draws at most `sheets` sheets. */
  build(shape: Shape, sheets: number) {
    const builder = build(shape);
    return { ...builder.report(), sheets: builder.sheets(0, sheets), layer: layerOf(builder) };
  },
  /** Changes the distance of its offset. */
  moveLayer(distance: number) {
    if (!builder) return null;
    builder.moveLayer(distance);
    return { ...builder.card(), layer: layerOf(builder) };
  },
  /** Changes the positions of its offset, during a drag. */
  reshape(positions: Float64Array) {
    if (!builder || !shape) return null;
    builder.reshape(positions);
    shape = { ...shape, positions };
    isReshaped = true;
    return { ...builder.card(), layer: layerOf(builder) };
  },
  /** The numbers that a lesson may bound, by id. */
  numbers: () => whole()?.numbers() ?? [],
  /** The errors of each kind of offset. */
  choices: () => builder?.choices() ?? [],
  /**
   * An HTML document.
   * @param camera of its picture: two angles in radians; null for the default
   */
  reportPage: (title: string, zUp: boolean, camera: Float64Array | null, link: string) =>
    whole()?.reportPage(title, zUp, camera, link) ?? null,
  spatialParts: (zUp: boolean) => whole()?.spatialParts(zUp) ?? [],
  /** All files in one archive. */
  zip(zUp: boolean) {
    const builder = whole();
    const files = builder?.files(zUp) ?? [];
    const entries = files.map(({ name, text }): [string, Uint8Array<ArrayBuffer>] => [
      name,
      new TextEncoder().encode(text),
    ]);
    if (builder) entries.push([PRESENTATION, new Uint8Array(builder.presentation(zUp))]);
    return archive(entries);
  },
};

export type BuildMethods = typeof methods;
export type Built = ReturnType<BuildMethods['build']>;
export type Reshaped = ReturnType<BuildMethods['reshape']>;

onmessage = async ({ data: { id, name, given } }: MessageEvent<Call>) => {
  try {
    await ready;
    const method = methods[name as keyof BuildMethods] as (...given: unknown[]) => unknown;
    const value = await method(...given);
    postMessage({ id, value }, value instanceof Uint8Array ? [value.buffer] : []);
  } catch (error) {
    postMessage({ id, refused: messageOf(error) });
  }
};
