/**
 * Choice of the graphics backend. The view's module is compiled twice: for WebGPU, where the
 * browser does most of the work, and for WebGL2, which includes a whole graphics library. What each
 * draws with is asked before either is loaded, and WebGPU is not retried after a failure.
 */

import { getItem, setItem } from '../ui/safe-storage.ts';
import { webgl2Card, webgpuCard } from './graphics-card.ts';

type Name = 'webgpu' | 'webgl2';

/** Key of the backend that drew last. */
const KEY = 'shape-up.backend';

const nameOf = (word: string | null): Name | null =>
  word === 'webgpu' || word === 'webgl2' ? word : null;

/** Returns the backend requested in the address (`?renderer=`). */
const demanded = () => nameOf(new URLSearchParams(location.search).get('renderer'));

/** Offline, only the module used before is available. */
const remembered = () => (navigator.onLine ? null : nameOf(getItem(KEY)));

/**
 * Returns the backend that draws fastest: WebGPU, unless it draws by software where WebGL2 has a
 * graphics card, which takes a twentieth of the time.
 */
async function fastest(): Promise<Name> {
  const card = await webgpuCard();
  if (card && !card.isSoftware) return 'webgpu';
  const other = webgl2Card();
  return card && (!other || other.isSoftware) ? 'webgpu' : 'webgl2';
}

export class Backend {
  #demanded = demanded() ?? remembered();
  #chosen: Promise<Name> | null = null;

  /** Returns the backend to draw with now. */
  choose() {
    if (this.#demanded) return this.#demanded;
    this.#chosen ??= fastest();
    return this.#chosen;
  }

  /**
   * Records that a backend could not draw.
   * @returns whether there is another one to try
   */
  failed(name: Name): boolean {
    if (this.#demanded || name === 'webgl2') return false;
    this.#chosen = Promise.resolve('webgl2');
    return true;
  }
}

/** Loads the module for a backend and opens a view on a canvas. */
export async function openView(canvas: HTMLCanvasElement, name: Name) {
  const { default: init, View } =
    name === 'webgpu'
      ? await import('../pkg/view-webgpu/shape_up.js')
      : await import('../pkg/view-webgl2/shape_up.js');
  await init();
  const view = await View.create(canvas, name);
  setItem(KEY, name);
  return view;
}

/**
 * Whether the canvas is blank: some drivers accept all commands and draw nothing. Every background
 * is lighter than black. Must be called in the same task as the drawing.
 */
export function isBlank(canvas: HTMLCanvasElement) {
  const [width, height] = [16, 16];
  const small = Object.assign(document.createElement('canvas'), { width, height });
  const context = small.getContext('2d');
  if (!context) return false;
  context.drawImage(canvas, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  // Every fourth byte is the opacity.
  return data.every((byte, i) => i % 4 === 3 || byte === 0);
}
