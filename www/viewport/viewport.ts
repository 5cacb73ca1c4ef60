/**
 * Lifecycle of the 3D view: its wasm module, canvas, size and pictures, and the fallback without
 * it. Every picture is a function of the store and of the solver's geometry; this module transfers
 * what changed and requests a picture.
 */

import { Backend, isBlank, openView } from './backend.ts';
import { isFirstPictureShown, removeFirstPicture } from './placeholder.ts';
import { Refinement } from './refinement.ts';
import { ShapeTransition } from './shape-transition.ts';
import { Emitter } from '../solver/emitter.ts';
import { messageOf } from '../solver/errors.ts';
import { LAYERS, showDisplay, showValues } from './layers.ts';
import { frameOf } from '../store/frame.ts';
import type { View } from '../pkg/view-webgl2/shape_up.js';
import type { State, Store } from '../store/state.ts';
import type { Geometry, SolverClient } from '../solver/solver-client.ts';
import type { Actions } from '../store/actions.ts';
import type { MoveConstraint } from '../store/handles.ts';

/** Label over the picture, in CSS pixels, with a bar of length `bar` below it. */
export type Label = { text: string; x: number; y: number; align: 'center' | 'right'; bar: number };

/** Number of consecutive losses after which the view is restored; the next one gives it up. */
const ATTEMPTS = 3;
/** Side in pixels of the tiles of larger pictures; every graphics card can draw this size. */
const TILE = 2048;
/** Drawing has become possible; it is impossible, with the reason; a picture was drawn. */
type ViewportEvents = { ready: void; none: string; drawn: void };

export class Viewport extends Emitter<ViewportEvents> {
  /** Reference of gestures and sizes, with the current canvas in it. */
  element: HTMLElement;
  /** Null during start-up and if nothing can draw. */
  view: View | null = null;
  /** What moves the camera by itself: a flight to a camera, or turning, to none; null while it rests. */
  motion: { to: Float64Array | null } | null = null;
  /** Returns the labels over the picture, for saved pictures. */
  labels: () => Label[] = () => [];

  #store;
  #solver;
  #actions;
  #backend = new Backend();
  /** Whether the first WebGPU picture was checked not to be blank. */
  #isProven = false;
  #canvas: HTMLCanvasElement | null = null;
  #attempts = 0;
  /** Size of the view in CSS pixels. */
  #size = [0, 0];
  /** Whether a picture is requested. */
  #asked = false;
  /** Camera last written to the store. */
  #camera: State['camera'] = null;
  /** Whether the mesh has been replaced since the last transfer. */
  #newMesh = false;
  /** Whether positions, values or fitted shapes are newer than the picture. */
  #newFrame = false;
  #transition: { shapes: ShapeTransition; arrived: () => void } | null = null;
  #refinement = new Refinement(() => this.requestPicture());

  constructor(element: HTMLElement, store: Store, solver: SolverClient, actions: Actions) {
    super();
    this.element = element;
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    this.#watchSize();
    this.#watchSolver();
    this.#watchStore();
    void this.#create();
  }

  /** Requests a picture for the next animation frame. */
  requestPicture() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => {
      this.#asked = false;
      this.#draw();
    });
  }

  /**
   * Calls a function with the view, if there is one, and requests a picture. The view has the
   * latest size, mesh and positions then, even if no picture shows them yet.
   */
  with<T>(action: (view: View) => T): T | undefined {
    if (this.view) this.#resize();
    return this.unmeasured(action);
  }

  /**
   * Does the same for actions that do not depend on the size of the view. Measuring forces a layout
   * when the page has changed, as in every frame of a drag.
   */
  unmeasured<T>(action: (view: View) => T): T | undefined {
    if (!this.view) return undefined;
    this.#handOver();
    this.requestPicture();
    return action(this.view);
  }

  /** Ends a flight at its destination; a model that turns goes on. */
  arrive() {
    this.unmeasured((view) => {
      if (!this.motion?.to) return;
      view.placeCamera(this.motion.to);
      this.motion = null;
    });
  }

  /**
   * Animates from the current shape to the next shapes of the solver.
   * @returns resolves at the end
   */
  transition(milliseconds: number): Promise<void> {
    this.endTransition();
    const { geometry } = this.#solver;
    if (!this.view || !geometry) return Promise.resolve();
    const shapes = new ShapeTransition(geometry, milliseconds);
    return new Promise((arrived) => (this.#transition = { shapes, arrived }));
  }

  /** Ends the animation and shows the latest shape. */
  endTransition() {
    this.#transition?.arrived();
    this.#transition = null;
  }

  /** Displacement of the held handle. */
  constrainMove: MoveConstraint = (direction, dx, dy) =>
    this.view?.constrainMove(direction, dx, dy);
  /** Position on the screen of the held handle after a displacement. */
  heldPosition = (by: number[]) => this.view?.heldPlace(by[0], by[1], by[2]);

  /** Width in CSS pixels as last measured, without a new layout. */
  get width() {
    return this.#size[0];
  }

  /**
   * Draws one picture of another size, with the proportions and the framing of the displayed one,
   * tile by tile: each tile is on the canvas only during the call of `take`, with its position in
   * the picture. Afterwards the displayed picture is drawn again.
   * @param size pixels, and pixels per CSS pixel
   * @param ground grey level from 0 to 1, with the light theme; else as displayed
   * @returns whether it could be drawn
   */
  still(
    { width, height, scale }: { width: number; height: number; scale: number },
    ground: number | undefined,
    take: (tile: HTMLCanvasElement, left: number, top: number) => void,
  ): boolean {
    const { view } = this;
    const canvas = this.#canvas;
    if (!view || !canvas) return false;
    this.#resize();
    this.#handOver();
    const [shownWidth, shownHeight] = [canvas.width, canvas.height];
    const { dark } = this.#store.get();
    try {
      this.arrive();
      if (ground !== undefined) view.setTheme(false);
      view.setGizmo(false, false);
      view.setBackground(ground);
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
        view.setBackground(undefined);
        view.setTheme(dark);
        showDisplay(view, this.#store.get());
        view.resize(shownWidth, shownHeight, shownWidth / this.#size[0]);
        this.#refinement.finish();
      }
    }
  }

  /** Returns the canvas as a video stream, if supported. */
  stream(): MediaStream | undefined {
    return this.#canvas?.captureStream?.();
  }

  /** Draws the next picture with the refinements that otherwise wait until nothing moves. */
  refine() {
    this.#refinement.finish();
  }

  /** Returns the visible lines as an SVG file for print; undefined without a view. */
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
    // The canvas may have been lost and replaced meanwhile.
    if (canvas !== this.#canvas) return;
    try {
      const view = await openView(canvas, backend);
      if (canvas !== this.#canvas) return view.free();
      this.view = view;
    } catch (thrown) {
      if (canvas !== this.#canvas) return;
      if (this.#backend.failed(backend)) void this.#create();
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

  #lost(reason: string) {
    const { renderer } = this.#store.get();
    const { view } = this;
    this.view = null;
    this.#canvas = null;
    // Freeing it may report a loss once more.
    view?.free();
    if (renderer !== 'webgpu' || !this.#backend.failed(renderer)) this.#attempts += 1;
    const isOver = this.#attempts > ATTEMPTS;
    this.#actions.setStatus(`The 3D view was lost${isOver ? '' : ' and is being restored'}`);
    if (isOver) this.#giveUp(reason);
    else void this.#create();
  }

  #giveUp(reason: string) {
    // No picture shows its end.
    this.endTransition();
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

  /** @param pixels exact size in device pixels, if the browser reports it */
  #resize(pixels?: [number, number]) {
    const { width, height } = this.element.getBoundingClientRect();
    if (!this.view || width === 0 || height === 0) return;
    // The observer reports a closed panel only just before the next picture.
    const isNew = width !== this.#size[0] || height !== this.#size[1];
    if (!isNew && !pixels) return;
    this.#size = [width, height];
    const rounded = [width, height].map((side) => Math.round(side * devicePixelRatio));
    // An emulated phone reports CSS pixels here.
    const exact = pixels?.every((side, i) => Math.abs(side - rounded[i]) <= 1) ? pixels : rounded;
    // The ratio for which the view's CSS pixels equal the page's.
    this.view.resize(exact[0], exact[1], exact[0] / width);
    this.requestPicture();
  }

  #watchSolver() {
    this.#solver.on('model', () => {
      this.#newMesh = true;
      this.endTransition();
      this.requestPicture();
    });
    this.#solver.on('frame', () => {
      this.#newFrame = true;
      this.requestPicture();
    });
  }

  #watchStore() {
    const { subscribe } = this.#store;
    subscribe(['heldOriginal'], () => {
      this.#newFrame = true;
      this.requestPicture();
    });
    for (const [keys, show] of LAYERS) {
      subscribe(keys, (state) => {
        // A mesh that has not been transferred yet will bring all layers with it.
        if (!this.#newMesh) this.unmeasured((view) => show(view, state, this.#solver.geometry));
      });
    }
    subscribe(['camera'], ({ camera }) => {
      if (!camera || camera === this.#camera || this.#newMesh) return;
      this.motion = null;
      this.unmeasured((view) => view.placeCamera(Float64Array.from(camera)));
    });
  }

  /** Returns the positions to show for the latest shape, `#V by 3`. */
  #positions(newest: Geometry, { heldOriginal }: State) {
    const positions = this.#transition?.shapes.towards(newest) ?? newest.positions;
    if (this.#transition?.shapes.part === 1) this.endTransition();
    if (this.#transition) {
      // During a transition the next picture differs even without a new frame.
      this.#newFrame = true;
      this.requestPicture();
    }
    return heldOriginal?.positions ?? positions;
  }

  /** Transfers what has changed to the view. */
  #handOver() {
    const { geometry } = this.#solver;
    const { view } = this;
    if (!view || !geometry || !(this.#newMesh || this.#newFrame)) return;
    const state = this.#store.get();
    if (this.#newMesh) {
      this.motion = null;
      const { faceOffsets, faceIndices, curveOffsets, curveIndices } = geometry.connectivity;
      view.setUp(frameOf(state).up);
      view.setMesh(faceOffsets, faceIndices, curveOffsets, curveIndices, geometry.positions);
      view.setEdges(geometry.connectivity.edges);
      this.#newMesh = false;
      LAYERS.forEach(([, show]) => show(view, state, geometry));
      view.fit();
      // The view may be new for the same mesh, or the mesh may be restored.
      if (state.camera) view.placeCamera(Float64Array.from(state.camera));
    }
    this.#newFrame = false;
    view.setPositions(this.#positions(geometry, state));
    showValues(view, state, geometry);
    if (geometry.shapes) view.setShapes(geometry.shapes);
    if (geometry.projections) {
      const { vertices, displacements, colours, outlines, palette } = geometry.projections;
      view.setProjections(vertices, displacements, colours, outlines, palette);
    }
  }

  #storeCamera(numbers: Float64Array) {
    // Another model that is opened takes the camera away, although the view may stay as it is.
    const { camera } = this.#store.get();
    if (camera?.every((number, i) => number === numbers[i])) return;
    this.#camera = [...numbers];
    this.#actions.look({ camera: this.#camera });
  }

  #draw() {
    this.#handOver();
    this.#solver.recycle();
    if (!this.#solver.geometry || !this.view) return;
    // Wait for the colours: the view replaces the first picture with its colours at once, and with
    // all refinements, which the picture has too.
    const isComplete = this.#store.get().spread !== null;
    if (isComplete && isFirstPictureShown()) this.#refinement.finish();
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
      if (isComplete) removeFirstPicture();
      this.#storeCamera(this.view.camera());
      this.emit('drawn', undefined);
    } catch (thrown) {
      this.#lost(messageOf(thrown));
    }
  }
}
