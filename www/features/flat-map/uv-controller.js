/**
 * Parametrisation: asks the worker for a flat map of the model, with the options chosen last, and
 * holds the panel and the part of the canvas that belong to it. Loaded when it is first asked for.
 */

import './flat-map.css';
import { byId } from '../../ui/dom.js';
import { duration } from '../../ui/format.js';
import { MapRegion } from './uv-view.js';
import { flatMapPanel } from './uv-panel.js';

/** @typedef {import("../../store/view-modes.js").FlatMap} FlatMap */

/** What can be chosen. @typedef {Pick<FlatMap, "weights" | "norm" | "onModel" | "onMap" | "squares">} Choices */

/** @type {Parametrize | null} */
let only = null;

export class Parametrize {
  #store;
  #viewport;
  #actions;
  /** @type {Choices} */
  #choices = {
    weights: 'inverse-area',
    norm: 'boundary',
    onModel: 'checks',
    onMap: 'errors',
    squares: 32,
  };

  /**
   * The one of the page.
   * @param {import("../../app/context.js").AppContext} app
   */
  static of(app) {
    only ??= new Parametrize(app);
    return only;
  }

  /** @param {import("../../app/context.js").AppContext} app */
  constructor({ store, viewport, actions }) {
    this.#store = store;
    this.#viewport = viewport;
    this.#actions = actions;
    flatMapPanel(byId('flat-map-section'), store, this);
    new MapRegion(byId('flat-map'), store, viewport);
  }

  async toggle() {
    if (this.#store.get().flatMap) this.close();
    else await this.flatten();
  }

  /** Back to the model alone. */
  close() {
    this.#actions.look({ flatMap: null, status: 'Back to the model' });
  }

  /**
   * Changes what is chosen: what only looks different at once, else with another map.
   * @param {Partial<Choices>} choices
   */
  choose(choices) {
    Object.assign(this.#choices, choices);
    const { flatMap } = this.#store.get();
    if ('weights' in choices || 'norm' in choices) this.flatten();
    else if (flatMap) this.#actions.look({ flatMap: { ...flatMap, ...choices } });
  }

  /** Selects the faces that the map turns over, and comes near them on the model and on the map. */
  showFlipped() {
    const { flatMap } = this.#store.get();
    if (!flatMap) return;
    this.#actions.select({ vertices: [], faces: flatMap.found.flippedFaces });
    this.#viewport.with((view) => view.showFlipped());
  }

  /** Makes the map of the shape as it is now. */
  async flatten() {
    const { model } = this.#store.get();
    const { weights, norm } = this.#choices;
    this.#actions.setStatus('Flattening …');
    try {
      const found = await this.#actions.parametrize(weights, norm);
      const { model: now, numbers } = this.#store.get();
      const isNewest = weights === this.#choices.weights && norm === this.#choices.norm;
      if (now !== model || !isNewest) return;
      const iteration = numbers?.iteration ?? 0;
      this.#actions.look({
        flatMap: { found, iteration, ...this.#choices },
        status: `Flattened in ${duration(1000 * found.seconds)}`,
      });
    } catch (error) {
      this.#actions.setStatus('');
      await this.#actions.reportErrors(Promise.reject(error));
    }
  }
}
