// npm run pictures: takes the pictures in www/pictures from the built site in a headless browser,
// those of the gallery and those of the first screen, and writes the results shown beside them. The
// pictures are kept in the repository, and the next build puts them into the site.
// npm run pictures -- first: takes those of the first screen only; the gallery takes some minutes.

import { chromium } from '@playwright/test';
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser, webgl2Flags } from './browser.mjs';
import { at } from './project.mjs';
import { main, Problem, run, say } from './run.mjs';
import { serve } from './serve.mjs';

const folder = at('www', 'pictures');
/** Limit of all pictures together, in bytes. */
const MOST = 1e6;

/** The view of a picture of the gallery in CSS pixels, and the width of the picture in pixels. */
const CARD = { width: 432, height: 312 };
const CARD_PICTURE = { width: 378, ground: 'none', quality: 0.5 };
/** Height of the bar below an embedded view, in CSS pixels. */
const BAR = 45;

/**
 * Windows of the first screen, the height of the part of the view around its middle that contains
 * the model, and pixels per CSS pixel.
 */
const WINDOWS = {
  wide: { viewport: { width: 1440, height: 900 }, part: 700, scale: 1, quality: 0.75 },
  narrow: { viewport: { width: 390, height: 844 }, part: 480, scale: 2, quality: 0.7 },
};
/** Width of the soft edge of a picture of the first screen, in CSS pixels. */
const SOFT = 20;

/**
 * In a page or frame: a picture of the view, or the given part of it, as WebP in base64. Its edge is
 * faded over `soft` pixels. Without a background it is also without the shadow on the ground, and
 * its opacity has few levels: the opacity takes most of the bytes.
 */
async function take({ width, ground, part, soft = 0, quality }) {
  const [FAINTEST, LEVELS] = [0.5, 15];
  const bitmap = await createImageBitmap(
    await window.shapeUp.picture({ width, ground, legend: false }),
  );
  const [left, top, across, high] = part ?? [0, 0, bitmap.width, bitmap.height];
  const canvas = Object.assign(document.createElement('canvas'), { width: across, height: high });
  const context = canvas.getContext('2d');
  context.drawImage(bitmap, -left, -top);
  if (ground === 'none') {
    const pixels = context.getImageData(0, 0, across, high);
    for (let at = 3; at < pixels.data.length; at += 4) {
      const opacity = pixels.data[at] / 255;
      const level = opacity < FAINTEST ? 0 : Math.round(LEVELS * opacity);
      pixels.data[at] = (255 * level) / LEVELS;
    }
    context.putImageData(pixels, 0, 0);
  }
  if (soft) {
    context.globalCompositeOperation = 'destination-in';
    for (const [x, y] of [
      [across, 0],
      [0, high],
    ]) {
      const fade = context.createLinearGradient(0, 0, x, y);
      const inside = soft / Math.max(x, y);
      for (const [at, colour] of Object.entries({ 0: '#0000', [inside]: '#000' })) {
        fade.addColorStop(at, colour);
        fade.addColorStop(1 - at, colour);
      }
      context.fillStyle = fade;
      context.fillRect(0, 0, across, high);
    }
  }
  const url = canvas.toDataURL('image/webp', quality);
  return url.slice(url.indexOf(',') + 1);
}

/** Writes a picture of the view in a page or frame. */
async function write(name, view, options) {
  await view.evaluate(() => window.shapeUp.drawn());
  const base64 = await view.evaluate(take, options);
  writeFileSync(join(folder, `${name}.webp`), base64, 'base64');
}

/** The first screen, solved, in each window and theme. */
async function takeFirst(browser, address) {
  for (const [name, { viewport, part, scale, quality }] of Object.entries(WINDOWS)) {
    for (const colorScheme of ['light', 'dark']) {
      const page = await browser.newPage({ viewport, colorScheme });
      await page.goto(address);
      await page.waitForFunction(
        () => window.shapeUp?.state().converged && !document.getElementById('first-picture'),
      );
      const { width, height } = await page.locator('#viewport').boundingBox();
      const all = [0, (height - part) / 2, width, part].map((side) => Math.round(side * scale));
      const options = { width: width * scale, ground: 'view', part: all, soft: SOFT * scale };
      await write(`first-${name}-${colorScheme}`, page, { ...options, quality });
      await page.close();
    }
  }
}

/** The page around two embedded views: of an example, and of what is framed. */
const AROUND = `<!doctype html><style>
iframe { border: 0; width: ${CARD.width}px; height: ${CARD.height + BAR}px }
</style>
<iframe name="example"></iframe><iframe name="framed"></iframe>`;

/** In the page around: keeps the last camera of each view, and passes calls to them. */
function around() {
  const cameras = {};
  const waiting = [];
  addEventListener('message', ({ source, data }) => {
    if (data.news === 'camera') cameras[source.name] = data.camera;
    if (data.shapeUp === 'answer') waiting[data.id](data);
  });
  const call = (name, asked) =>
    new Promise((done) => {
      const id = waiting.push(done) - 1;
      frames[name].postMessage({ shapeUp: 'call', id, ...asked }, '*');
    });
  Object.assign(window, { cameras, call });
}

/** Opens the page around two embedded views. */
async function openViews(browser, address) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 800 } });
  page.on('pageerror', (error) => console.error(error));
  const url = new URL('around.html', address).href;
  await page.route(url, (route) => route.fulfill({ contentType: 'text/html', body: AROUND }));
  await page.goto(url);
  await page.evaluate(around);
  return page;
}

/** Loads an embedded view, with the first example or the one of a link; resolves with its frame. */
async function load(page, address, name, link = '') {
  const frame = page.frame({ name });
  // Another fragment alone would not reload it.
  await frame.goto('about:blank');
  await frame.goto(`${address}?embed=called&theme=light${link}`);
  await frame.waitForFunction(() => window.shapeUp?.state().energy, null, { timeout: 0 });
  await frame.evaluate(() => window.shapeUp.drawn());
  return frame;
}

/** The camera that shows all points, with the standard direction of view. */
async function cameraFor(page, points, up) {
  const vertices = Array.from({ length: points.length / 3 }, (_, v) => v);
  const positions = vertices.map((v) => points.slice(3 * v, 3 * v + 3));
  const scene = { format: 'shape-up-scene', version: 1, up, mesh: { positions, faces: [] } };
  const call = (asked) => page.evaluate((it) => window.call('framed', it), asked);
  await call({ name: 'open', text: JSON.stringify(scene) });
  await page.frame({ name: 'framed' }).evaluate(() => window.shapeUp.drawn());
  // Its answer comes after the news of the camera.
  await call({ name: 'state' });
  const camera = await page.evaluate(() => window.cameras.framed);
  // The last number would adapt it to elements in front of the view.
  return [...camera.slice(0, -1), 0];
}

/**
 * In the page around: runs the example until it converges, or iterates it to the limit of its scene,
 * at which the command line stops. Meanwhile the view is tiny: drawing in software takes longer than
 * solving. Returns the energy.
 */
async function solve(limit) {
  const { shapeUp } = window.frames.example;
  const { style } = document.querySelector('[name=example]');
  style.width = style.height = '60px';
  await shapeUp.drawn();
  for (let left = limit; left > 0 && !shapeUp.state().converged; left--)
    await window.call('example', { name: 'step' });
  if (!limit) await window.call('example', { name: 'run' });
  while (shapeUp.state().running || shapeUp.state().iteration === 0)
    await new Promise((done) => setTimeout(done, 50));
  await shapeUp.drawn();
  style.width = style.height = '';
  return shapeUp.state().energy.total;
}

/**
 * Loads an example and solves it, so that its energy is that of the results; returns its frame, and
 * its positions before and after.
 */
async function loadSolved(page, address, { id, energy: [start, end] }) {
  const isNear = (total) => Math.abs(total - end) <= 0.01 * end + 1e-9 * start;
  // A run is the fastest and meets hard constraints, but has no limit.
  for (const isLimited of [false, true]) {
    const frame = await load(page, address, 'example', `#example=${id}`);
    const positions = () => frame.evaluate(() => [...window.shapeUp.positions()]);
    const { solver, up = 'z' } = await frame.evaluate(() => window.shapeUp.scene());
    const before = await positions();
    const total = await page.evaluate(solve, isLimited ? (solver?.iterations ?? 200) : 0);
    if (isNear(total)) return { frame, up, points: [...before, ...(await positions())] };
  }
  throw new Problem(`${id}: the page does not get the energy ${end} of its results`);
}

/** Takes both pictures of an example with the same camera. */
async function takeSolved(page, address, result) {
  const { frame, up, points } = await loadSolved(page, address, result);
  const camera = await cameraFor(page, points, up);
  const call = (asked) => page.evaluate((it) => window.call('example', it), asked);
  await call({ name: 'camera', camera });
  await write(`${result.id}-end`, frame, CARD_PICTURE);
  const unsolved = await load(page, address, 'example', `#example=${result.id}`);
  await call({ name: 'camera', camera });
  await write(`${result.id}-start`, unsolved, CARD_PICTURE);
}

/** Takes the pictures of an example without constraints: its end is its flat map. */
async function takeFlattened(page, address, { id }) {
  const frame = await load(page, address, 'example', `#example=${id}`);
  await write(`${id}-start`, frame, CARD_PICTURE);
  // The map has a half of the view.
  const view = page.locator('iframe[name=example]');
  await view.evaluate((element, width) => (element.style.width = `${2 * width}px`), CARD.width);
  await frame.evaluate(() => document.querySelector('[data-command=parametrize]').click());
  const map = frame.getByRole('application', { name: 'Flat map' });
  await map.waitFor();
  const scale = CARD_PICTURE.width / CARD.width;
  const part = await map.evaluate((element, factor) => {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = element;
    return [offsetLeft, offsetTop, offsetWidth, offsetHeight].map((side) =>
      Math.round(side * factor),
    );
  }, scale);
  await write(`${id}-end`, frame, { ...CARD_PICTURE, width: 2 * CARD_PICTURE.width, part });
  await view.evaluate((element) => element.removeAttribute('style'));
}

async function takeGallery(browser, address) {
  const page = await openViews(browser, address);
  await load(page, address, 'framed');
  const results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
  for (const result of results) {
    await (result.energy ? takeSolved : takeFlattened)(page, address, result);
  }
}

/** Solves the examples and writes the results that the gallery shows. */
const solveExamples = () =>
  run(
    'cargo',
    ['test', '--locked', '--quiet', '--features', 'view', '--test', 'native', 'gallery'],
    { env: { UPDATE: '1' } },
  );

await main(async () => {
  const onlyFirst = process.argv.includes('first');
  if (!onlyFirst) {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder);
    say('solving the examples for their results');
    await solveExamples();
  }
  const { address, close } = await serve(at('dist'), { port: 4273 });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: webgl2Flags,
  });
  try {
    say('taking pictures of the first screen');
    await takeFirst(browser, address);
    if (onlyFirst) return;
    say('taking pictures of the gallery');
    await takeGallery(browser, address);
  } finally {
    await browser.close();
    close();
  }
  const bytes = readdirSync(folder).reduce(
    (sum, name) => sum + statSync(join(folder, name)).size,
    0,
  );
  if (bytes > MOST) throw new Problem(`The pictures have ${bytes} bytes, more than ${MOST}`);
});
