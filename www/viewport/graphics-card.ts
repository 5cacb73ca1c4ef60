/** What a graphics interface of the browser draws with: a graphics card, or software in its place. */

import type { State } from '../store/state.ts';

interface GraphicsCard {
  /** as the browser calls it; empty if it does not say */
  name: string;
  isSoftware: boolean;
}

/**
 * Timeout for a driver that may never answer: number of waits, and milliseconds each. A single long
 * wait could expire before its answer is processed, while the page itself is busy.
 */
const [WAITS, WAIT] = [30, 100];

/** Names of software renderers: of Chromium, of Mesa, of Windows and of macOS. */
const SOFTWARE = /swiftshader|llvmpipe|lavapipe|softpipe|basic render|software/i;

/** The parts of an adapter that tell it, which some versions of TypeScript's declarations lack. */
interface Adapter {
  isFallbackAdapter?: boolean;
  info?: {
    vendor?: string;
    architecture?: string;
    description?: string;
    isFallbackAdapter?: boolean;
  };
}

async function timeout() {
  for (let i = 0; i < WAITS; i++) await new Promise((done) => setTimeout(done, WAIT));
  return null;
}

/** Returns what WebGPU draws with; null without an adapter. */
export async function webgpuCard(): Promise<GraphicsCard | null> {
  const { gpu } = navigator as { gpu?: { requestAdapter(): Promise<Adapter | null> } };
  const asked = gpu?.requestAdapter().catch(() => null);
  const adapter = await Promise.race([asked, timeout()]);
  if (!adapter) return null;
  const { vendor = '', architecture = '', description = '', ...info } = adapter.info ?? {};
  const name = description || `${vendor} ${architecture}`.trim();
  const isFallback = info.isFallbackAdapter ?? adapter.isFallbackAdapter;
  return { name, isSoftware: isFallback || SOFTWARE.test(`${name} ${architecture}`) };
}

/** Returns what WebGL2 draws with; null where there is none. */
export function webgl2Card(): GraphicsCard | null {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return null;
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  // Browsers allow few contexts at a time.
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { name, isSoftware: SOFTWARE.test(name) };
}

/** The interfaces of the browser that can draw: their names, and what each draws with. */
export const INTERFACES: {
  [name in State['renderer']]?: {
    label: string;
    cardOf: () => GraphicsCard | null | Promise<GraphicsCard | null>;
  };
} = {
  webgpu: { label: 'WebGPU', cardOf: webgpuCard },
  webgl2: { label: 'WebGL2', cardOf: webgl2Card },
};

/** Whether the view is drawn without a graphics card. */
export const drawsInSoftware = async (renderer: State['renderer']) =>
  (await INTERFACES[renderer]?.cardOf())?.isSoftware ?? false;
