/** Parts of a shape, made in the second worker. */

import { zipSync, type Zippable } from 'fflate';
import { Builder, buildOffers, type Site } from '../../pkg/engine/shape_up.js';
import type { BuildSettings } from '../../solver/types.ts';

/** A shape (positions `#V by 3`), and what is to be made of it. */
export interface Shape {
  positions: Float64Array;
  offsets: Uint32Array;
  indices: Uint32Array;
  /** vertices whose positions are guesses */
  unplaced: Uint32Array;
  /** number of faces, the last ones, that are left as they are */
  untouched: number;
  settings: BuildSettings;
  site: Site;
}

/** The parts of one shape; each user has its own, so that none changes those of another. */
class Parts {
  builder: Builder | null = null;
  #shape: Shape | null = null;
  /** Whether the positions belong to the offset only. */
  #isReshaped = false;

  renew(shape: Shape) {
    const { positions, offsets, indices, unplaced, untouched, settings, site } = shape;
    this.builder?.free();
    this.builder = this.#shape = null;
    this.builder = new Builder(positions, offsets, indices, unplaced, untouched, settings, site);
    this.#shape = shape;
    this.#isReshaped = false;
    return this.builder;
  }

  /** Changes the positions of the offset only. */
  reshape(positions: Float64Array) {
    if (!this.builder || !this.#shape) return null;
    this.builder.reshape(positions);
    this.#shape = { ...this.#shape, positions };
    this.#isReshaped = true;
    return this.builder;
  }

  /** The parts of the current shape, made again first if only the offset has followed it. */
  whole() {
    const builder = this.#shape && this.#isReshaped ? this.renew(this.#shape) : this.builder;
    if (!builder) throw new Error('No parts have been made.');
    return builder;
  }
}

/** Whose parts they are: those of the panel, and those of the goals of a lesson. */
export type PartsOwner = 'panel' | 'goals';

const parts: Record<PartsOwner, Parts> = { panel: new Parts(), goals: new Parts() };

/** All but `buildOffers` and `build` are about the last build of their owner. */
export const builds = {
  /** The presets, the declared settings and their defaults. */
  buildOffers: () => buildOffers(),
  /** Makes the parts of a shape, and draws at most `sheets` sheets. */
  build(owner: PartsOwner, shape: Shape, sheets: number) {
    const builder = parts[owner].renew(shape);
    return { ...builder.report(), sheets: builder.sheets(sheets), layer: builder.layer() };
  },
  /** Changes the distance of its offset. */
  moveLayer(owner: PartsOwner, distance: number) {
    const { builder } = parts[owner];
    if (!builder) return null;
    builder.moveLayer(distance);
    return { ...builder.card(), layer: builder.layer() };
  },
  /** Changes the positions of its offset, during a drag. */
  reshape(owner: PartsOwner, positions: Float64Array) {
    const builder = parts[owner].reshape(positions);
    return builder && { ...builder.card(), layer: builder.layer() };
  },
  /** The numbers that a lesson may bound, by id. */
  buildNumbers: (owner: PartsOwner) => parts[owner].whole().numbers(),
  /** The errors of each kind of offset. */
  offsetChoices: (owner: PartsOwner) => parts[owner].builder?.choices() ?? [],
  /**
   * An HTML document.
   * @param camera of its picture: two angles in radians; null for the default
   */
  reportPage: (owner: PartsOwner, title: string, camera: Float64Array | null, link: string) =>
    parts[owner].whole().reportPage(title, camera, link),
  spatialParts: (owner: PartsOwner) => parts[owner].whole().spatialParts(),
  /** All files in one archive. */
  zipParts(owner: PartsOwner) {
    const builder = parts[owner].whole();
    const files: Zippable = {};
    for (const { name, bytes } of builder.files()) files[name] = bytes;
    return zipSync(files);
  },
};

export type Built = ReturnType<typeof builds.build>;
export type Reshaped = ReturnType<typeof builds.reshape>;
