/** Keeps the parts up to date with the shape: one request at a time, for the newest state. */

import { messageOf, retryIfCollateral, wasCollateral } from '../../solver/errors.ts';
import type { Connectivity, Document as SceneDocument } from '../../pkg/engine/shape_up.js';
import type { PartsOwner, BuildSettings, Built, Reshaped } from '../../solver/types.ts';
import { latestOnly, MOST_LIVE_VERTICES } from '../../store/latest-only.ts';
import { metresOf } from '../../ui/words.ts';
import type { AppContext } from '../../app/context.ts';

/** Longest build, in ms, for which the sheets follow a moving shape; the offset always follows. */
const LIVE_MS = 100;
/** Maximum number of sheets drawn. */
export const MOST_SHEETS = 24;

/** The faces of a mesh, then those that are left as they are, which may be panels with holes. */
function allFaces(mesh: Connectivity) {
  const { faceOffsets, faceIndices, untouchedOffsets, untouchedIndices, unplaced } = mesh;
  const ends = untouchedOffsets.subarray(1).map((end) => faceIndices.length + end);
  return {
    offsets: joined(faceOffsets, ends),
    indices: joined(faceIndices, untouchedIndices),
    unplaced,
    untouched: ends.length,
  };
}

function joined(first: Uint32Array, last: Uint32Array) {
  const both = new Uint32Array(first.length + last.length);
  both.set(first);
  both.set(last, first.length);
  return both;
}

interface Listener {
  show: (built: Built) => void;
  /** called while the shape moves */
  showOffset: (reshaped: Reshaped) => void;
  refuse: (why: string) => void;
}

export class LiveBuild {
  #app;
  #owner: PartsOwner;
  #builds = latestOnly(() => this.#once());
  /** Generations of the worker and of the shape, and settings of the last build. */
  #key = '';
  /** Mesh of the last build, generation of its shape, and its document. */
  #mesh: object | null = null;
  #generation = 0;
  #document: SceneDocument | null = null;
  /** Settings of the last build; empty if it was refused. */
  #agreed = '';
  /** Duration of the last build. */
  #milliseconds = 0;
  #defaults: BuildSettings | null = null;
  #on;

  constructor(app: AppContext, owner: PartsOwner, on: Listener) {
    this.#app = app;
    this.#owner = owner;
    this.#on = on;
  }

  /** Returns the presets, the declared settings and their defaults. */
  async offers() {
    const offers = await retryIfCollateral(() => this.#app.jobs.ask.buildOffers());
    this.#defaults = offers.defaults;
    return offers;
  }

  /** The settings of the scene, completed by the defaults. */
  settings(document: SceneDocument | null = this.#app.store.get().document): BuildSettings {
    return { ...(this.#defaults as BuildSettings), ...document?.build };
  }

  /** The unit of the mesh; metres if the file has none. Nothing is built in one that is not known. */
  unit() {
    const symbol = this.#app.store.get().document?.units ?? '';
    const metres = metresOf(symbol);
    return metres === undefined ? { symbol: 'm', metres: 1 } : { symbol, metres };
  }

  /** Builds even if nothing has changed. */
  again() {
    this.#key = '';
    return this.update();
  }

  /** Builds what has changed; during a build, once more after it. */
  update() {
    return this.#builds.ask();
  }

  /** @param isSaved whether the parts are built of the shape as it is, however long it takes */
  async #once(isSaved: boolean = false): Promise<void> {
    const { store, solver, jobs } = this.#app;
    const { model, document, running, dragged } = store.get();
    const { geometry } = solver;
    if (!model || !document || !geometry || !this.#defaults) return;
    const isMoving = running || dragged.length > 0;
    if (isMoving && !isSaved && model.vertices > MOST_LIVE_VERTICES) return;
    const settings = this.settings();
    const symbol = document.units ?? '';
    const { connectivity: mesh, generation } = geometry;
    const positions = geometry.positions.slice();
    const held = document.handles.filter(({ fixed }) => fixed).map(({ vertex }) => vertex);
    const site = { symbol, z_up: document.up === 'z', held };
    const agreed = JSON.stringify([site, settings]);
    const keyNow = () => [jobs.generation, generation, agreed].join();
    const key = keyNow();
    if (key === this.#key) return;
    const isOther = mesh !== this.#mesh || agreed !== this.#agreed;
    const isSlow = this.#milliseconds > LIVE_MS;
    try {
      if (isMoving && isSlow && !isOther && !isSaved) {
        // The last build no longer belongs to this shape.
        this.#key = '';
        return await this.#offset(jobs.ask.reshape(this.#owner, positions));
      }
      [this.#key, this.#mesh, this.#agreed] = [key, mesh, agreed];
      [this.#generation, this.#document] = [generation, document];
      const faces = allFaces(mesh);
      const shape = { positions, ...faces, settings, site };
      const begun = performance.now();
      const built = await jobs.ask.build(this.#owner, shape, MOST_SHEETS);
      this.#milliseconds = performance.now() - begun;
      if (this.#isOf(mesh)) this.#on.show(built);
    } catch (error) {
      this.#agreed = '';
      // It was in the way of another job, which was cancelled.
      if (wasCollateral(error)) return await this.#once(isSaved);
      // A build that was cancelled, or has ended its worker, is not begun again by itself.
      this.#key = keyNow();
      if (this.#isOf(mesh)) this.#on.refuse(messageOf(error));
      if (isSaved) throw error;
    }
  }

  /**
   * Shows the offset at another distance.
   * @param distance in the unit of the mesh
   */
  moveLayer(distance: number) {
    return this.#offset(this.#ofLast(() => this.#app.jobs.ask.moveLayer(this.#owner, distance)));
  }

  /** Shows an offset unless another mesh has been opened meanwhile. */
  async #offset(made: Promise<Reshaped>) {
    const { geometry } = this.#app.solver;
    const reshaped = await made;
    if (this.#isOf(geometry?.connectivity)) this.#on.showOffset(reshaped);
  }

  /** Whether this mesh is open. */
  #isOf(mesh: object | undefined) {
    return this.#app.solver.geometry?.connectivity === mesh;
  }

  /** The error of each kind of offset. */
  choices() {
    return this.#ofLast(() => this.#app.jobs.ask.offsetChoices(this.#owner));
  }

  /** Asks about the last build, which is made again if its worker has ended for another job. */
  #ofLast<Answer>(ask: () => Promise<Answer>) {
    return retryIfCollateral(ask, () => this.#once(true));
  }

  /** Builds what the user sees and has begun to change, and asks for what is saved of it. */
  #whole<Answer>(ask: () => Promise<Answer>) {
    return retryIfCollateral(async () => {
      await this.#app.actions.settled();
      await this.#once(true);
      return ask();
    });
  }

  /** All files as a ZIP archive. */
  zip() {
    return this.#whole(() => this.#app.jobs.ask.zipParts(this.#owner));
  }

  /** Whether the last build is of shape and document as they are now. */
  isCurrent() {
    const { solver, store } = this.#app;
    const isOfShape = solver.geometry?.generation === this.#generation;
    return isOfShape && store.get().document === this.#document;
  }

  /** The numbers that a lesson may bound. */
  numbers() {
    return this.#ofLast(() => this.#app.jobs.ask.buildNumbers(this.#owner));
  }

  /** The parts in space and the sheets, for CAD programs. */
  spatialParts() {
    return this.#whole(() => this.#app.jobs.ask.spatialParts(this.#owner));
  }

  /** The report. */
  reportPage({
    title,
    camera,
    link,
  }: {
    title: string;
    camera: Float64Array | null;
    link: string;
  }) {
    return this.#whole(() => this.#app.jobs.ask.reportPage(this.#owner, title, camera, link));
  }
}

/**
 * Follows lesson goals on the parts. Their numbers are measured in the second worker, so that
 * iterations do not wait, while the shape is at rest; the session discards them when it moves.
 */
export async function measureGoals(app: AppContext) {
  const { store, actions } = app;
  const live = new LiveBuild(app, 'goals', {
    show() {
      actions.look({ goalsRefused: '' });
      void actions.reportErrors(tell());
    },
    showOffset: () => {},
    refuse(why) {
      actions.look({ goalsRefused: why });
      void actions.reportErrors(actions.setBuildNumbers([]));
    },
  });
  await live.offers();

  async function tell() {
    const numbers = await live.numbers();
    await actions.settled();
    // Of another shape, or with other settings, they say nothing; that is built in its turn.
    if (live.isCurrent()) await actions.setBuildNumbers(numbers);
  }

  const isAsked = () =>
    !store.get().running && store.get().document?.lesson?.goals.some(({ build }) => build);
  store.subscribe(['running', 'document'], () => {
    if (isAsked()) void live.again();
  });
  store.subscribe(['numbers'], () => {
    if (isAsked()) void live.update();
  });
}
