/** What the second worker computes on a copy of the open model. */

import { ModelCopy, type LayoutSettings } from '../../pkg/engine/shape_up.js';
import type { MapNorm, MapWeights, Snapshot } from '../../solver/types.ts';

/** Duration of a slice of a trial, in milliseconds: other calls wait no longer. */
const SLICE_MS = 25;

let copy: ModelCopy | null = null;
/** What it is a copy of. */
let copied: Snapshot | null = null;

/** Opens the model, unless it is the one that is open. */
function copyOf(model: Snapshot): ModelCopy {
  const { text, generation } = model;
  // A new worker of the solver counts its generations anew.
  if (copy && copied?.generation === generation && copied.text === text) return copy;
  copy?.free();
  // The constructor may throw.
  copy = copied = null;
  copy = new ModelCopy(text, generation);
  copied = model;
  return copy;
}

/** The copy on which something was begun. */
function current(): ModelCopy {
  if (!copy) throw new Error('nothing has been begun');
  return copy;
}

const tell = (told: string) => postMessage({ told });

export const onCopy = {
  /** How far making panels of one shape will move the mesh, in words; null if none is offered. */
  forecast: (model: Snapshot) => copyOf(model).forecast() ?? null,
  /**
   * Panels along the lines of curvature; what is being done is told in words.
   * @param kept faces that stay as they are
   */
  layOutPanels: (model: Snapshot, settings: LayoutSettings, kept: Uint32Array) =>
    copyOf(model).layOutPanels(settings, kept, tell),
  /** What such panels come to with each choice at the boundary; empty if there is none. */
  panelsAtBoundaries: (model: Snapshot, settings: LayoutSettings, kept: Uint32Array) =>
    copyOf(model).panelsAtBoundaries(settings, kept, tell),
  /** The place of the last refusal of panels; null if it has none. */
  panelsRefusedAt: () => current().panelsRefusedAt() ?? null,
  /** A flat map of the shape. */
  parametrize: (model: Snapshot, weights: MapWeights, norm: MapNorm) =>
    copyOf(model).parametrize(weights, norm),
  /** The settings of the map with the fewest flips, if fewer than `flipped`. */
  fewerFlips: (model: Snapshot, flipped: number) => copyOf(model).fewerFlips(flipped),

  /** Begins to meet exactly what is met within a distance. */
  tryExact: (model: Snapshot) => copyOf(model).tryExact(),
  /** Begins to search for lower energy among equally exact shapes. */
  tryImprovement: (model: Snapshot) => copyOf(model).tryImprovement(),
  /** Begins to try changes that lower the worst distance. */
  tryRemedies: (model: Snapshot) => copyOf(model).tryRemedies(),
  /** Begins to try presses for panels that end better than the last one. */
  tryPresses: (model: Snapshot) => copyOf(model).tryPresses(),
  /**
   * Continues what was begun last, for a slice.
   * @returns whether there is more to do
   */
  advance: () => current().advance(SLICE_MS),
  /** The exact shape found so far, with its cost; null if there is nothing to make exact. */
  found() {
    const copy = current();
    const [offer, shape] = [copy.offer(), copy.shape()];
    return offer && shape ? { offer, shape, positions: copy.positions() } : null;
  },
  /** The presses that end better, as far as they were tried. */
  betterPresses: () => current().betterPresses(),
  /** The changes found so far, most effective first. */
  remedies: () => current().remedies(),

  /**
   * Begins the search for variations of an exact shape.
   * @returns whether there can be any
   */
  findVariations: (model: Snapshot) => copyOf(model).findVariations(),
  /** Continues the search for a slice. */
  advanceVariations: () => current().advanceVariations(SLICE_MS),
  /** The displacement of a variation, `#V by 3`. */
  variation: (index: number) => current().variation(index),
  /** The positions of the shape plus the variations times their coefficients. */
  towards: (coefficients: Float64Array) => current().towards(coefficients),
  /** The same, projected back onto the constraints. */
  go: (coefficients: Float64Array) => current().go(coefficients),
};

export type ExactFound = NonNullable<ReturnType<typeof onCopy.found>>;
