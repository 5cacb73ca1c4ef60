// The cost of shading: frames of a turning model with and without it, alternately, drawn by
// software in headless Chromium.

import { findBrowser, webgl2Flags } from '../browser.mjs';
import { at } from '../project.mjs';
import { say } from '../run.mjs';
import { buildModule } from '../wasm.mjs';
import { host, isolation } from './host.mjs';
import { quadsOf } from './problems.mjs';
import { median, spread } from './statistics.mjs';

const WINDOW = { width: 1440, height: 900 };
const TRIANGLES = 20_000;

/** Amounts of shading, by name: ambient occlusion, and the background gradient with the shadow. */
export const LOOKS = {
  'nothing of it': { occlusion: 0, ground: 0.9 },
  'in motion, where pictures are slow': { occlusion: 0 },
  'all of it': { occlusion: 1 },
};

/** A square grid of quads, each split into two triangles. */
function trianglesOf(count) {
  const { positions, indices } = quadsOf((Math.round(Math.sqrt(count / 2)) + 1) ** 2);
  const corners = [];
  for (let i = 0; i < indices.length; i += 4) {
    const [a, b, c, d] = indices.subarray(i, i + 4);
    corners.push(a, b, c, a, c, d);
  }
  return { positions: [...positions], corners };
}

/** In the page: milliseconds of frames for each setting in turn; the model turns before each. */
async function drawInTurn({ looks, rounds, positions, corners, width, height }) {
  const { default: init, View } = await import('/view/shape_up.js');
  await init();
  const canvas = document.body.appendChild(document.createElement('canvas'));
  const view = await View.create(canvas, 'webgl2');
  view.resize(width, height, 1);
  const offsets = Uint32Array.from({ length: corners.length / 3 + 1 }, (_, face) => 3 * face);
  const none = new Uint32Array(0);
  view.setMesh(offsets, Uint32Array.from(corners), new Uint32Array(1), none, positions);
  const gl = canvas.getContext('webgl2');
  const pixel = new Uint8Array(4);
  const frame = ({ occlusion, ground }) => {
    view.orbit(4, 1);
    view.setOcclusion(occlusion);
    view.setGround(ground);
    const began = performance.now();
    view.draw();
    // Reading a pixel waits until the picture is complete.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return performance.now() - began;
  };
  const times = looks.map(() => []);
  // The first frames compile shaders and are not counted.
  for (let round = -2; round < rounds; round++) {
    looks.forEach((look, i) => {
      const took = frame(look);
      if (round >= 0) times[i].push(took);
    });
    await new Promise(requestAnimationFrame);
  }
  return times;
}

/** Returns a row per setting: milliseconds per frame, and their ratio to the first setting. */
export async function measureLook({ trial }) {
  const { chromium } = await import('@playwright/test');
  await buildModule('view-webgl2');
  say(`drawing ${TRIANGLES} triangles with and without the look`);
  const { address, close } = await host({
    folders: { '/view/': at('www', 'pkg', 'view-webgl2') },
    pages: { '/': '<!doctype html><title>look</title>' },
    headers: isolation,
  });
  const executablePath = (await findBrowser()) ?? undefined;
  const browser = await chromium.launch({ executablePath, args: webgl2Flags });
  try {
    const page = await browser.newPage({ viewport: WINDOW });
    await page.goto(address);
    const mesh = trianglesOf(TRIANGLES);
    const asked = { looks: Object.values(LOOKS), rounds: trial ? 2 : 15, ...mesh, ...WINDOW };
    const times = await page.evaluate(drawInTurn, asked);
    return Object.keys(LOOKS).map((look, i) => {
      // Relative to the frame of the same round, when the machine was equally busy.
      const ratio = median(times[i].map((ms, round) => ms / times[0][round]));
      return { look, triangles: mesh.corners.length / 3, ...spread(times[i]), ratio };
    });
  } finally {
    await browser.close();
    close();
  }
}
