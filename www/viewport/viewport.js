/**
 * The 3D view's life: its wasm module, its canvas, its size, its pictures, and what to do without
 * it. Everything that is drawn is a function of the store and of the solver's geometry; this module
 * hands over what changed and asks for one picture.
 */

import { Backend, isBlank, openView } from './backend.js';
import { removeFirstPicture } from './placeholder/placeholder-scene.js';
import { Refinement } from './refinement.js';
import { ShapeTransition } from './shape-transition.js';
import { Emitter } from '../solver/emitter.js';
import { messageOf } from '../solver/messages.js';
import { LAYERS, showDisplay, showValues } from './layers.js';

/** @typedef {import("../pkg/view-webgl2/shape_up.js").View} View */
/** @typedef {import("../store/state.js").State} State */
/**
 * Words over the picture, in CSS pixels, with a bar below them that is so long.
 * @typedef {{ text: string, x: number, y: number, align: "center" | "right", bar: number }} Label
 */

/** A view that is lost this often in a row is given up. */
const ATTEMPTS = 3;
/** A larger picture is drawn in tiles of so many pixels, which every graphics card can. */
const TILE = 2048;
/**
 * Something can draw; nothing can, and why; a picture was drawn.
 * @typedef {{ ready: void, none: string, drawn: void }} ViewportEvents
 */

/** @extends {Emitter<ViewportEvents>} */
export class Viewport extends Emitter {
  /** The element that gestures and sizes refer to; canvases come and go in it. @type {HTMLElement} */
  element;
  /** None while it starts, and where nothing can draw. @type {View | null} */
  view = null;
  /** What the page writes over the picture, for those that are saved. @type {() => Label[]} */
  labels = () => [];

  #store;
  #solver;
  #actions;
  #backend = new Backend();
  /** WebGPU is asked once whether its picture is there. */
  #isProven = false;
  /** @type {HTMLCanvasElement | null} */
  #canvas = null;
  #attempts = 0;
  /** Width and height that the view has, in CSS pixels. */
  #size = [0, 0];
  /** A picture is asked for. */
  #asked = false;
  /** Where the camera is, as the store was told. @type {import("../store/state.js").State["camera"]} */
  #camera = null;
  /** The mesh itself is another one. */
  #newMesh = false;
  /** The positions, values or fitted shapes are newer than the picture. */
  #newFrame = false;
  /** @type {{ shapes: ShapeTransition, arrived: () => void } | null} */
  #transition = null;
  #refinement = new Refinement(() => this.ask());

  /**
   * @param {HTMLElement} element
   * @param {import("../store/state.js").Store} store
   * @param {import("../solver/solver-client.js").SolverClient} solver
   * @param {import("../store/actions.js").Actions} actions
   */
  constructor(element, store, solver, actions) {
    super();
    this.element = element;
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    this.#watchSize();
    this.#watchSolver();
    this.#watchStore();
    this.#create();
  }

  /** Asks for a picture before the next one of the page. */
  ask() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => {
      this.#asked = false;
      this.#draw();
    });
  }

  /**
   * Does something with the view, if there is one, and draws what changed. The view has the newest
   * size, mesh and positions then, also when no picture shows them yet.
   * @template T
   * @param {(view: View) => T} action
   * @returns {T | undefined}
   */
  with(action) {
    if (this.view) this.#resize();
    return this.unmeasured(action);
  }

  /**
   * The same for what does not depend on the size of the view. To measure lays the page out anew
   * when something has changed on it, as in every frame of a drag.
   * @template T
   * @param {(view: View) => T} action
   * @returns {T | undefined}
   */
  unmeasured(action) {
    if (!this.view) return undefined;
    this.#handOver();
    this.ask();
    return action(this.view);
  }

  /**
   * Goes from the shape as it is to the next ones of the solver gradually.
   * @param {number} milliseconds
   * @returns {Promise<void>} when it is there
   */
  transition(milliseconds) {
    this.endTransition();
    const { geometry } = this.#solver;
    if (!this.view || !geometry) return Promise.resolve();
    const shapes = new ShapeTransition(geometry.positions, milliseconds);
    return new Promise((arrived) => (this.#transition = { shapes, arrived }));
  }

  /** Shows the newest shape from now on. */
  endTransition() {
    this.#transition?.arrived();
    this.#transition = null;
  }

  /** How far what the view holds goes with the pointer. @type {import("../store/handle-drag.js").Hold} */
  constrainMove = (way, dx, dy) => this.view?.constrainMove(way, dx, dy);
  /** Where what the view holds is seen once it has gone so far. @param {number[]} by */
  heldPlace = (by) => this.view?.heldPlace(by[0], by[1], by[2]);

  /** In CSS pixels, as the view has it: without measuring the page again. */
  get width() {
    return this.#size[0];
  }

  /**
   * Draws one picture of another size, in the proportions and the framing of the one that is shown, tile by
   * tile: each is on the canvas while `take` is called with it and its place in the picture, and must be read
   * at once. The shown one is drawn again then.
   * @param {{ width: number, height: number, scale: number }} size in pixels; `scale` of them are a CSS pixel
   * @param {number | undefined} ground a grey from 0 to 1, with the light colours, or as it is shown
   * @param {(tile: HTMLCanvasElement, left: number, top: number) => void} take
   * @returns {boolean} whether it could be drawn
   */
  still({ width, height, scale }, ground, take) {
    const { view } = this;
    const canvas = this.#canvas;
    if (!view || !canvas) return false;
    this.#resize();
    this.#handOver();
    const [shownWidth, shownHeight] = [canvas.width, canvas.height];
    const { dark } = this.#store.get();
    try {
      view.arrive();
      if (ground !== undefined) view.setTheme(false);
      view.setGizmo(false, false);
      view.setGround(ground);
      view.setOcclusion(1);
      for (let top = 0; top < height; top += TILE)
        for (let left = 0; left < width; left += TILE) {
          const size = [Math.min(TILE, width - left), Math.min(TILE, height - top)];
          view.setTile(width, height, scale, Uint32Array.of(left, top, ...size));
          if (!view.draw()) return false;
          take(canvas, left, top);
        }
      return true;
    } catch (thrown) {
      this.#lost(messageOf(thrown));
      return false;
    } finally {
      if (this.view === view) {
        view.setGround(undefined);
        view.setTheme(dark);
        showDisplay(view, this.#store.get());
        view.resize(shownWidth, shownHeight, shownWidth / this.#size[0]);
        this.#refinement.finish();
      }
    }
  }

  /** What is drawn as a stream of pictures; none where the browser has no such thing. @returns {MediaStream | undefined} */
  stream() {
    return this.#canvas?.captureStream?.();
  }

  /** Shows all that the view shows once nothing moves, with the next picture. */
  refine() {
    this.#refinement.finish();
  }

  /** The lines that are seen, as an SVG file for print; nothing without a view. */
  lineDrawing() {
    this.#handOver();
    return this.view?.lineDrawing();
  }

  async #create() {
    const canvas = document.createElement('canvas');
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      if (canvas === this.#canvas) this.#lost('the graphics context was lost');
    });
    this.#canvas = canvas;
    this.element.replaceChildren(canvas);
    const backend = await this.#backend.choose();
    // It may have been lost by now, and another one have taken its place.
    if (canvas !== this.#canvas) return;
    try {
      const view = await openView(canvas, backend);
      if (canvas !== this.#canvas) return view.free();
      this.view = view;
    } catch (thrown) {
      if (canvas !== this.#canvas) return;
      if (this.#backend.failed(backend)) this.#create();
      else this.#giveUp(messageOf(thrown));
      return;
    }
    this.#size = [0, 0];
    this.#resize();
    this.#newMesh = true;
    this.#handOver();
    this.#actions.look({ renderer: backend });
    this.emit('ready', undefined);
  }

  /** @param {string} reason */
  #lost(reason) {
    const { renderer } = this.#store.get();
    const { view } = this;
    this.view = null;
    this.#canvas = null;
    // It may call for help once more.
    view?.free();
    if (renderer !== 'webgpu' || !this.#backend.failed(renderer)) this.#attempts += 1;
    const isOver = this.#attempts > ATTEMPTS;
    this.#actions.setStatus(`The 3D view was lost${isOver ? '' : ' and is being restored'}`);
    if (isOver) this.#giveUp(reason);
    else this.#create();
  }

  /** @param {string} reason */
  #giveUp(reason) {
    this.view = null;
    this.#canvas = null;
    this.element.replaceChildren();
    removeFirstPicture();
    this.#actions.look({ renderer: 'none' });
    this.emit('none', reason);
  }

  #watchSize() {
    const observer = new ResizeObserver((entries) => {
      const pixels = entries[0].devicePixelContentBoxSize?.[0];
      this.#resize(pixels && [pixels.inlineSize, pixels.blockSize]);
    });
    try {
      observer.observe(this.element, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(this.element);
    }
  }

  /** @param {[number, number]} [pixels] the exact size, where the browser tells */
  #resize(pixels) {
    const { width, height } = this.element.getBoundingClientRect();
    if (!this.view || width === 0 || height === 0) return;
    // The observer tells of a panel that was closed only before the next picture.
    const isNew = width !== this.#size[0] || height !== this.#size[1];
    if (!isNew && !pixels) return;
    this.#size = [width, height];
    const rounded = [width, height].map((side) => Math.round(side * devicePixelRatio));
    // An emulated phone tells CSS pixels here.
    const exact = pixels?.every((side, i) => Math.abs(side - rounded[i]) <= 1) ? pixels : rounded;
    // The ratio that makes the view's CSS pixels those of the page.
    this.view.resize(exact[0], exact[1], exact[0] / width);
    this.ask();
  }

  #watchSolver() {
    this.#solver.on('model', () => {
      this.#newMesh = true;
      this.endTransition();
      this.ask();
    });
    this.#solver.on('frame', () => {
      this.#newFrame = true;
      this.ask();
    });
  }

  #watchStore() {
    const { subscribe } = this.#store;
    subscribe(['heldOriginal'], () => {
      this.#newFrame = true;
      this.ask();
    });
    for (const [keys, show] of LAYERS) {
      subscribe(keys, (state) => {
        // A mesh that has not been handed over yet brings all of this with it.
        if (!this.#newMesh) this.unmeasured((view) => show(view, state, this.#solver.geometry));
      });
    }
    subscribe(['camera'], ({ camera }) => {
      if (!camera || camera === this.#camera || this.#newMesh) return;
      this.unmeasured((view) => view.placeCamera(Float64Array.from(camera)));
    });
  }

  /**
   * Those that are shown for the newest ones, `#V by 3`.
   * @param {Float64Array} newest
   * @param {State} state
   */
  #positions(newest, { heldOriginal }) {
    const positions = this.#transition?.shapes.towards(newest) ?? newest;
    if (this.#transition?.shapes.part === 1) this.endTransition();
    if (this.#transition) {
      // The next picture is another one without a frame, too.
      this.#newFrame = true;
      this.ask();
    }
    return heldOriginal?.positions ?? positions;
  }

  /** Gives the view what is newer than what it has. */
  #handOver() {
    const { geometry } = this.#solver;
    const { view } = this;
    if (!view || !geometry || !(this.#newMesh || this.#newFrame)) return;
    const state = this.#store.get();
    if (this.#newMesh) {
      const { faceOffsets, faceIndices, curveOffsets, curveIndices } = geometry.connectivity;
      if (state.model) view.setUp(state.model.up);
      view.setMesh(faceOffsets, faceIndices, curveOffsets, curveIndices, geometry.positions);
      view.setEdges(geometry.connectivity.edges);
      this.#newMesh = false;
      LAYERS.forEach(([, show]) => show(view, state, geometry));
      view.fit();
      // The view may be a new one of the same mesh, and the mesh may be restored.
      if (state.camera) view.placeCamera(Float64Array.from(state.camera));
    }
    this.#newFrame = false;
    view.setPositions(this.#positions(geometry.positions, state));
    showValues(view, state, geometry);
    if (geometry.shapes) view.setShapes(geometry.shapes);
    if (geometry.projections) {
      const { vertices, ways, colours, outlines, palette } = geometry.projections;
      view.setProjections(vertices, ways, colours, outlines, palette);
    }
  }

  /** @param {Float64Array} numbers */
  #storeCamera(numbers) {
    const isSame = this.#camera?.every((number, i) => number === numbers[i]);
    if (isSame) return;
    this.#camera = [...numbers];
    this.#actions.look({ camera: this.#camera });
  }

  #draw() {
    this.#handOver();
    this.#solver.recycle();
    // Without a mesh there is nothing to draw.
    if (!this.#solver.geometry || !this.view) return;
    this.#refinement.prepare(this.view);
    if (!this.view.needsDraw()) return;
    try {
      if (!this.view.draw()) return;
      if (!this.#isProven && this.view.backend() === 'webgpu' && this.#canvas) {
        if (isBlank(this.#canvas)) return this.#lost('the picture stays empty');
        this.#isProven = true;
      }
      this.#attempts = 0;
      this.#refinement.drawn();
      // Which has its colours at once.
      if (this.#store.get().spread) removeFirstPicture();
      this.#storeCamera(this.view.camera());
      this.emit('drawn', undefined);
    } catch (thrown) {
      this.#lost(messageOf(thrown));
    }
  }
}
