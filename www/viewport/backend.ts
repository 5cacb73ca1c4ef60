/**
 * Choice of the graphics backend. The view's module is compiled twice: for WebGPU, where the
 * browser does most of the work, and for WebGL2, which includes a whole graphics library. WebGPU
 * support is tested before either is loaded, and WebGPU is not retried after a failure.
 */

import { getItem, setItem } from '../ui/safe-storage.ts';

type Name = 'webgpu' | 'webgl2';

/**
 * Timeout for a driver that may never answer: number of waits, and milliseconds each. A single long
 * wait could expire before its answer is processed, while the page itself is busy.
 */
const [WAITS, WAIT] = [30, 100];

/** Key of the backend that drew last. */
const KEY = 'shape-up.backend';

const nameOf = (word: string | null): Name | null =>
  word === 'webgpu' || word === 'webgl2' ? word : null;

/** Returns the backend requested in the address (`?backend=`). */
function demanded() {
  const named = new URLSearchParams(location.search).get('backend');
  return nameOf(named === 'webgl' ? 'webgl2' : named);
}

/** Offline, only the module used before is available. */
const remembered = () => (navigator.onLine ? null : nameOf(getItem(KEY)));

async function timeout() {
  for (let i = 0; i < WAITS; i++) await new Promise((done) => setTimeout(done, WAIT));
  return null;
}

/** Whether WebGPU has an adapter, in hardware or software. */
async function hasWebgpu() {
  // `navigator.gpu` is missing in some browsers and in some versions of TypeScript's declarations.
  const { gpu } = navigator as { gpu?: { requestAdapter(): Promise<unknown> } };
  const adapter = gpu?.requestAdapter().catch(() => null);
  return Boolean(await Promise.race([adapter, timeout()]));
}

export class Backend {
  #demanded = demanded() ?? remembered();
  #chosen: Promise<Name> | null = null;

  /** Returns the backend to draw with now. */
  choose() {
    if (this.#demanded) return this.#demanded;
    this.#chosen ??= hasWebgpu().then((has) => (has ? 'webgpu' : 'webgl2'));
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
