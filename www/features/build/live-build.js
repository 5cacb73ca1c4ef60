/** Keeps the parts those of the current shape: one request at a time, and then the newest. */

import { messageOf } from '../../solver/messages.js';
import { UNITS } from '../../ui/units.js';
import { BuildClient } from './build-client.js';

/** @typedef {import("../../solver/messages.js").BuildReplies["build"]} Built */
/** @typedef {import("../../solver/messages.js").BuildSettings} BuildSettings */

/** Larger meshes are built when they have come to rest. */
export const MOST_LIVE_VERTICES = 3000;
/** So many sheets are drawn. */
export const MOST_SHEETS = 24;

export class LiveBuild {
  #app;
  #client = new BuildClient();
  #isAsking = false;
  #isStale = false;
  /** What was built last. */
  #key = '';
  /** @type {BuildSettings | null} */
  #defaults = null;
  /** @type {(built: Built) => void} */
  #show;
  /** @type {(why: string) => void} */
  #refuse;

  /**
   * @param {import("../../app/context.js").AppContext} app
   * @param {(built: Built) => void} show
   * @param {(why: string) => void} refuse
   */
  constructor(app, show, refuse) {
    this.#app = app;
    this.#show = show;
    this.#refuse = refuse;
  }

  /** Presets, and the defaults. */
  async offers() {
    const offers = await this.#client.ask({ type: 'offers' });
    this.#defaults = offers.defaults;
    return offers;
  }

  /** The settings of the scene over the defaults. */
  settings() {
    const { document } = this.#app.store.get();
    return { .../** @type {BuildSettings} */ (this.#defaults), ...document?.build };
  }

  /** The unit of the mesh: metres where the file says none. */
  unit() {
    const symbol = this.#app.store.get().document?.units ?? '';
    return UNITS.find((unit) => unit.symbol === symbol) ?? UNITS[0];
  }

  /** Builds although nothing has changed. */
  again() {
    this.#key = '';
    return this.update();
  }

  /** Builds what has changed since. */
  async update() {
    this.#isStale = true;
    if (this.#isAsking) return;
    this.#isAsking = true;
    while (this.#isStale) {
      this.#isStale = false;
      await this.#once();
    }
    this.#isAsking = false;
  }

  async #once() {
    const { store, solver } = this.#app;
    const { model, numbers, document, running } = store.get();
    const { geometry } = solver;
    if (!model || !document || !geometry || !this.#defaults) return;
    if (!model.faces) {
      this.#key = '';
      return this.#refuse(
        'The model has no faces: there is nothing to cut. Parts are made of panels.',
      );
    }
    if (running && model.vertices > MOST_LIVE_VERTICES) return;
    const settings = this.settings();
    const { symbol, metres } = this.unit();
    const { faceOffsets: offsets, faceIndices: indices } = geometry.connectivity;
    const positions = geometry.positions.slice();
    const key = [numbers?.iteration, sum(positions), symbol, JSON.stringify(settings)].join();
    if (key === this.#key) return;
    this.#key = key;
    const shape = { positions, offsets, indices, symbol, metres };
    try {
      const request = { type: /** @type {const} */ ('build'), ...shape, settings };
      this.#show(await this.#client.ask({ ...request, sheets: MOST_SHEETS }));
    } catch (error) {
      this.#refuse(messageOf(error));
    }
  }

  /** The offset at another distance, while somebody tries some. @param {number} distance in the unit of the mesh */
  moveLayer(distance) {
    return this.#client.ask({ type: 'moveLayer', distance });
  }

  /** What each kind of offset would have for errors. */
  choices() {
    return this.#client.ask({ type: 'choices' });
  }

  /** All files in one. */
  zip() {
    return this.#client.ask({ type: 'zip', zUp: this.#isZUp() });
  }

  /** The numbers that a lesson may bound. */
  numbers() {
    return this.#client.ask({ type: 'numbers' });
  }

  /** Everything in space, and its sheets, for CAD programs. */
  spatialParts() {
    return this.#client.ask({ type: 'spatialParts', zUp: this.#isZUp() });
  }

  /** The report on one page. @param {{ title: string, camera: Float64Array | null, link: string }} view */
  reportPage(view) {
    return this.#client.ask({ type: 'reportPage', zUp: this.#isZUp(), ...view });
  }

  #isZUp() {
    return this.#app.store.get().document?.up === 'z';
  }
}

/** Tells whether a shape has moved. @param {Float64Array} positions */
function sum(positions) {
  let sum = 0;
  for (let i = 0; i < positions.length; i++) sum += positions[i] * ((i % 7) + 1);
  return sum;
}
