/**
 * What draws. The view's module is compiled twice: for WebGPU, where the browser does most of the
 * work, and for WebGL2, which brings a whole graphics library along. A browser is asked before either
 * is loaded, and WebGPU that failed once is not tried again.
 */

import { recall, remember } from '../ui/safe-storage.js';

/** @typedef {"webgpu" | "webgl2"} Name */

/**
 * A driver that has not answered after so many waits of so many milliseconds may never do. One long
 * wait could be over before its answer is looked at, while the page itself is busy.
 */
const [WAITS, WAIT] = [30, 100];

/** Where the last one that drew is noted. */
const KEY = 'shape-up.backend';

/** @param {string | null} word @returns {Name | null} */
const nameOf = (word) => (word === 'webgpu' || word === 'webgl2' ? word : null);

/** The one that the address asks for. */
function demanded() {
  const named = new URLSearchParams(location.search).get('backend');
  return nameOf(named === 'webgl' ? 'webgl2' : named);
}

/** Without a network only the module is there that was used before. */
const kept = () => (navigator.onLine ? null : nameOf(recall(KEY)));

async function waitForLong() {
  for (let i = 0; i < WAITS; i++) await new Promise((done) => setTimeout(done, WAIT));
  return null;
}

/** Whether a graphics card, or what stands in for it, answers for WebGPU. */
async function hasWebgpu() {
  // Neither every browser nor every version of TypeScript's declarations has it.
  const { gpu } = /** @type {{ gpu?: { requestAdapter(): Promise<unknown> } }} */ (navigator);
  const adapter = gpu?.requestAdapter().catch(() => null);
  return Boolean(await Promise.race([adapter, waitForLong()]));
}

export class Backend {
  #demanded = demanded() ?? kept();
  /** @type {Promise<Name> | null} */
  #chosen = null;

  /** The one to draw with now. */
  choose() {
    if (this.#demanded) return this.#demanded;
    this.#chosen ??= hasWebgpu().then((has) => (has ? 'webgpu' : 'webgl2'));
    return this.#chosen;
  }

  /**
   * Takes note that one could not draw.
   * @param {Name} name
   * @returns {boolean} whether there is another one
   */
  failed(name) {
    if (this.#demanded || name === 'webgl2') return false;
    this.#chosen = Promise.resolve('webgl2');
    return true;
  }
}

/**
 * Loads the module for a backend and opens a view on a canvas.
 * @param {HTMLCanvasElement} canvas
 * @param {Name} name
 */
export async function openView(canvas, name) {
  const { default: init, View } =
    name === 'webgpu'
      ? await import('../pkg/view-webgpu/shape_up.js')
      : await import('../pkg/view-webgl2/shape_up.js');
  await init();
  const view = await View.create(canvas, name);
  remember(KEY, name);
  return view;
}

/**
 * Whether nothing was drawn: some drivers take all commands and draw nothing. No background of a
 * picture is quite black. To be asked in the task that drew.
 * @param {HTMLCanvasElement} canvas
 */
export function isBlank(canvas) {
  const [width, height] = [16, 16];
  const small = Object.assign(document.createElement('canvas'), { width, height });
  const context = small.getContext('2d');
  if (!context) return false;
  context.drawImage(canvas, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  // The fourth of each pixel is its opacity.
  return data.every((byte, i) => i % 4 === 3 || byte === 0);
}
