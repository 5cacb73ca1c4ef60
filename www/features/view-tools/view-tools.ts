/**
 * The view tools: flights to named views, the original for the ghost and the ground grid, the
 * scale and the measuring tape.
 */

import './view-tools.css';
import { newestOnly } from '../../store/latest-only.ts';
import { element, setText } from '../../ui/dom.ts';
import { limit, rounded } from '../../ui/words.ts';
import { fly } from '../../viewport/camera.ts';
import { Tape } from './tape.ts';
import type { AppContext } from '../../app/context.ts';
import type { Label } from '../../viewport/viewport.ts';

/** Maximum length of the scale bar in CSS pixels. */
const BAR = 120;

export class ViewTools {
  #app;
  #tape;
  #bar = element('i');
  #scaleText = element('span');
  #scale = element('div', { id: 'scale' }, this.#bar, this.#scaleText);
  /** The model whose rest positions are stored or requested. */
  #model: unknown = null;
  /** Rest positions of that model, #V by 3. */
  #rest: Float64Array | null = null;

  #newest = newestOnly(() => this.#app.store.get().model);

  constructor(app: AppContext) {
    this.#app = app;
    this.#tape = new Tape(app);
    const { store, viewport } = app;
    viewport.element.after(this.#scale);
    viewport.on('ready', () => this.#handOver());
    viewport.on('drawn', () => this.#show());
    store.subscribe(['model', 'display', 'tape', 'parallel', 'flatMap', 'document'], () => {
      void this.#takeRest();
      this.#show();
    });
    viewport.labels = () => [...this.#scaleLabels(), ...this.#tape.labels()];
  }

  /** Turns the camera to a named view, in a short flight unless the user prefers reduced motion. */
  flyTo(name: string) {
    const { parallel } = this.#app.store.get();
    this.#app.actions.setStatus(`View: ${name}${parallel ? ', parallel' : ''}`);
    fly(this.#app.viewport, (view) => view.preset(name));
  }

  /** Requests the original positions, once for each model that needs them. */
  async #takeRest() {
    const { model, display, tape } = this.#app.store.get();
    if (!model || model === this.#model) return;
    if (!display.ghost && !display.ground && !tape) return;
    this.#model = model;
    this.#rest = null;
    const rest = await this.#newest(this.#app.actions.originalPositions());
    if (!rest) return;
    this.#rest = rest;
    this.#handOver();
  }

  #handOver() {
    const rest = this.#rest;
    if (rest && this.#app.store.get().model === this.#model)
      this.#app.viewport.with((view) => view.setRest(rest));
  }

  /** The scale: the size of the grid's squares, or in parallel projection a scale bar. */
  #scaleNow() {
    const { document, flatMap, parallel } = this.#app.store.get();
    const { view } = this.#app.viewport;
    if (!view || !document || flatMap) return { text: '', pixels: 0 };
    const step = view.gridStep();
    if (!parallel) {
      const text = step === undefined ? '' : `Grid ${roundLength(step, document.units)}`;
      return { text, pixels: 0 };
    }
    const [long, pixels] = view.scaleBar(BAR);
    return { text: roundLength(long, document.units), pixels };
  }

  #show() {
    const { text, pixels } = this.#scaleNow();
    this.#scale.hidden = text === '';
    setText(this.#scaleText, text);
    this.#bar.style.width = `${pixels}px`;
    this.#bar.hidden = pixels === 0;
    this.#tape.show();
  }

  #scaleLabels(): Label[] {
    const { text, pixels } = this.#scaleNow();
    if (text === '') return [];
    const box = this.#app.viewport.element.getBoundingClientRect();
    return [{ text, x: box.width - 14, y: box.height - 14, align: 'right', bar: pixels }];
  }
}

/**
 * A round length with its unit: 5 m, not 5.00 m.
 * @param units of the mesh
 */
function roundLength(value: number, units: string) {
  return limit(rounded(value, 3), units);
}
