/** Flat maps of the model, made with the options that were chosen last. */

import { newestOnly } from '../../store/latest-only.ts';
import { duration } from '../../ui/words.ts';
import { once } from '../../ui/once.ts';
import type { ConformalNorm, ConformalWeights } from '../../pkg/engine/shape_up.js';
import type { Snapshot } from '../../solver/types.ts';
import type { FlatMap } from '../../store/state.ts';
import type { AppContext } from '../../app/context.ts';

/** Other settings are tried without asking if a map takes less than this, in seconds. */
const QUICK = 0.3;
const FLATTENING = 'Flattening …';

type Choices = Pick<FlatMap, 'weights' | 'norm' | 'onModel' | 'onMap' | 'squares'>;

/** The flat maps of the page. */
export const flatMaps = once((app: AppContext) => new FlatMaps(app));

class FlatMaps {
  #app;
  #choices: Choices = {
    weights: 'inverse-area',
    norm: 'boundary',
    onModel: 'checks',
    onMap: 'errors',
    squares: 32,
  };

  /** The shape of the map that is shown. */
  #flattened: Snapshot | null = null;
  /** A map that is closed while the next one is made stays closed. */
  #newest = newestOnly(
    () => this.#app.store.get().model,
    () => this.#app.store.get().flatMap === null,
  );

  constructor(app: AppContext) {
    this.#app = app;
  }

  toggle() {
    if (this.#app.store.get().flatMap) this.close();
    else return this.flatten();
  }

  /** Closes the flat map. */
  close() {
    this.#app.actions.look({ flatMap: null, status: 'Back to the model' });
  }

  /** Changes options. Options of appearance apply at once; the others require a new map. */
  choose(choices: Partial<Choices>) {
    Object.assign(this.#choices, choices);
    const { flatMap } = this.#app.store.get();
    if ('weights' in choices || 'norm' in choices) void this.flatten();
    else if (flatMap) this.#app.actions.look({ flatMap: { ...flatMap, ...choices } });
  }

  /** Selects the faces that the map flips, and zooms to them on the model and on the map. */
  showFlipped() {
    const { flatMap } = this.#app.store.get();
    if (!flatMap) return;
    this.#app.actions.select({ vertices: [], faces: flatMap.found.flippedFaces });
    this.#app.viewport.with((view) => view.showFlipped());
  }

  /** Looks for settings that flip fewer triangles of the flattened shape. A run goes on. */
  async findFewerFlips() {
    const { flatMap } = this.#app.store.get();
    const model = this.#flattened;
    if (!flatMap || !model) return;
    const { found } = flatMap;
    const show = (fewerFlips: FlatMap['fewerFlips']) => {
      const now = this.#app.store.get().flatMap;
      if (now?.found === found) this.#app.actions.look({ flatMap: { ...now, fewerFlips } });
    };
    show('searching');
    const search = async () => {
      try {
        show((await this.#app.jobs.copy(model).fewerFlips(found.flipped)) ?? 'none');
      } catch (error) {
        show(null);
        throw error;
      }
    };
    await this.#app.actions.reportErrors(search());
  }

  /** Withdraws the status of a map that was closed while it was made. */
  #sayNothing() {
    const { flatMap, status } = this.#app.store.get();
    if (!flatMap && status === FLATTENING) this.#app.actions.setStatus('');
  }

  async #map(weights: ConformalWeights, norm: ConformalNorm) {
    const model = await this.#app.actions.rest();
    const [found, shape] = await Promise.all([
      this.#app.jobs.copy(model).parametrize(weights, norm),
      this.#shapeOf(model),
    ]);
    return { model, found, shape };
  }

  /** The positions of the model: the frame that has them may come after it. */
  async #shapeOf({ generation }: Snapshot) {
    const solver = this.#app.solver;
    if (solver.geometry?.solved !== generation)
      await new Promise((come) => solver.once('frame', come));
    return solver.geometry?.positions.slice() ?? new Float64Array(0);
  }

  /** Shows the map of the current shape. */
  async flatten() {
    const { weights, norm } = this.#choices;
    this.#app.actions.setStatus(FLATTENING);
    try {
      const map = await this.#newest(this.#map(weights, norm));
      if (!map) return this.#sayNothing();
      const { model, found, shape } = map;
      this.#flattened = model;
      this.#app.actions.look({
        flatMap: { found, shape, fewerFlips: null, ...this.#choices },
        status: `Flattened in ${duration(1000 * found.seconds)}`,
      });
      // Every map of a surface without boundary folds over itself.
      const isOpen = found.closedParts < found.parts;
      if (found.flipped > 0 && isOpen && found.seconds < QUICK) await this.findFewerFlips();
    } catch (error) {
      this.#app.actions.setStatus('');
      // The panel shows those of the map that is there, and the next one begins with them.
      const { flatMap } = this.#app.store.get();
      if (flatMap) Object.assign(this.#choices, { weights: flatMap.weights, norm: flatMap.norm });
      await this.#app.actions.reportErrors(Promise.reject(error));
    }
  }
}
