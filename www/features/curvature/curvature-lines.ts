/**
 * The lines on the current shape: one request at a time to the second worker, always for the latest
 * shape and request.
 */

import { signal } from '@preact/signals';
import { latestOnly, MOST_LIVE_VERTICES } from '../../store/latest-only.ts';
import { messageOf, retryIfCollateral } from '../../solver/errors.ts';
import { RENEW_MS, throttled } from '../../ui/dom.ts';
import type { Lines, LinesQuestion } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** What is to be drawn. */
export type LinesRequest = Omit<LinesQuestion, 'shape'>;

export class CurvatureLines {
  /** What was found last, or why nothing was. */
  readonly result = signal<{ answer: Lines | null; refused: string }>({
    answer: null,
    refused: '',
  });
  #app;
  #request: LinesRequest | null = null;
  /** Generation of the shape that the worker has; 0 if none. */
  #known = 0;
  /** The last question. */
  #asked: unknown[] = [];
  #updates = latestOnly(() => this.#update());
  #soon = throttled(RENEW_MS, () => void this.#updates.ask());

  constructor(app: AppContext) {
    this.#app = app;
  }

  /** Follows the shape, until the returned function is called, which removes the lines. */
  begin() {
    const { store, solver, viewport } = this.#app;
    const stops = [
      solver.on('frame', this.#soon),
      store.subscribe(['running', 'model'], this.#soon),
      viewport.on('ready', () => this.#draw()),
    ];
    return () => {
      stops.forEach((stop) => stop());
      this.#request = null;
      this.#clear();
    };
  }

  /** @param request null for no lines */
  async draw(request: LinesRequest | null) {
    this.#request = request;
    await this.#updates.ask();
  }

  async #update() {
    const { store, solver, jobs } = this.#app;
    const { model, running } = store.get();
    const { geometry } = solver;
    const how = this.#request;
    if (!how || !model || !geometry) return this.#clear();
    if (running && model.vertices > MOST_LIVE_VERTICES) return;
    const { generation, positions, connectivity } = geometry;
    const { faceOffsets: offsets, faceIndices: indices } = connectivity;
    const question = [generation, how.draw, how.distance];
    if (question.every((part, i) => part === this.#asked[i])) return;
    this.#asked = question;
    const shape = { positions: positions.slice(), offsets, indices };
    const ask = (how: LinesQuestion) => jobs.ask.surfaceLines(how);
    let answer: Lines | null = null;
    let refused = '';
    try {
      answer = generation === this.#known ? await retryIfCollateral(() => ask(how)) : null;
      // The worker lacks the shape, or what it had was lost.
      answer ??= await retryIfCollateral(() => ask({ ...how, shape }));
    } catch (error) {
      refused = messageOf(error);
    }
    // A worker that refuses may not have taken the shape.
    this.#known = answer ? generation : 0;
    // Another mesh may have been opened since.
    if (store.get().model !== model || !this.#request) return;
    this.result.value = { answer, refused };
    this.#draw();
  }

  #clear() {
    const isDrawn = this.result.value.answer !== null;
    this.#asked = [];
    this.result.value = { answer: null, refused: '' };
    // Another card may have drawn its lines since.
    if (isDrawn) this.#draw();
  }

  #draw() {
    const { answer } = this.result.value;
    const { points = new Float64Array(0), offsets = new Uint32Array(1), count = 0 } = answer ?? {};
    this.#app.viewport.unmeasured((view) => view.setSurfaceLines(points, offsets, count));
  }
}
