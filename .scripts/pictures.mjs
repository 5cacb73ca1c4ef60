// npm run pictures: takes the pictures in www/pictures from the built site in a headless browser,
// those of the gallery and those of the first screen, and writes the results shown beside them. The
// pictures are kept in the repository, and the next build puts them into the site.
// npm run pictures -- first: takes those of the first screen only; the gallery takes some minutes.
// npm run pictures -- readme: takes those of the README, in .github.
// npm run pictures -- example=ID: takes those of one example, whose results are there.

import { chromium } from '@playwright/test';
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { findBrowser, webgl2Flags } from './browser.mjs';
import { at } from './project.mjs';
import { main, Problem, run, say } from './run.mjs';
import { serve } from './serve.mjs';
import { takeReadme } from './readme-pictures.mjs';

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
  wide: { viewport: { width: 1440, height: 900 }, part: 700, scale: 1, quality: 0.3 },
  narrow: { viewport: { width: 390, height: 844 }, part: 480, scale: 2, quality: 0.55 },
};
/** Width of the soft edge of a picture of the first screen, in CSS pixels. */
const SOFT = 20;

/**
 * In a page: a picture of the view, or the given part of it, as WebP in base64. Its edge is faded
 * over `soft` pixels. Without a background it is also without the shadow on the ground, and its
 * opacity has few levels: the opacity takes most of the bytes.
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

/** Writes a picture of the view in a page. */
async function write(name, page, options) {
  await page.evaluate(() => window.shapeUp.drawn());
  const base64 = await page.evaluate(take, options);
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

/** The window of an embedded view with the size of a picture, or of one that is `wider` times as wide. */
const windowOf = (wider = 1) => ({ width: wider * CARD.width, height: CARD.height + BAR });
/** A window in which drawing in software takes no time. */
const TINY = { width: 60, height: 60 };

/** Loads an embedded view, with the first example or the one of a link. */
async function load(page, address, link = '') {
  // Another fragment alone would not reload it.
  await page.goto('about:blank');
  await page.goto(`${address}?embed=pressed&theme=light${link}`);
  await page.waitForFunction(() => window.shapeUp?.state().energy, null, { timeout: 0 });
  await page.evaluate(() => window.shapeUp.drawn());
}

/** The camera that shows all points, with the standard direction of view. */
async function cameraFor(page, points, up) {
  const vertices = Array.from({ length: points.length / 3 }, (_, v) => v);
  const positions = vertices.map((v) => points.slice(3 * v, 3 * v + 3));
  const scene = { format: 'shape-up-scene', version: 1, up, mesh: { positions, faces: [] } };
  await page.evaluate((it) => window.shapeUp.open(it), scene);
  await page.evaluate(() => window.shapeUp.drawn());
  const camera = await page.evaluate(() => window.shapeUp.camera());
  // The last number would adapt it to elements in front of the view.
  return [...camera.slice(0, -1), 0];
}

/** Moves the camera of a view. */
const look = (page, camera) => page.evaluate((it) => window.shapeUp.look(it), camera);

/**
 * In the page: runs the example until it converges, or iterates it to the limit of its scene, at
 * which the command line stops. Returns the energy.
 */
async function solve(limit) {
  const { shapeUp } = window;
  const press = (command) => document.querySelector(`[data-command=${command}]`).click();
  for (let left = limit; left > 0 && !shapeUp.state().converged; left--) {
    press('step');
    await shapeUp.settled();
  }
  if (!limit) press('run');
  while (shapeUp.state().running || shapeUp.state().iteration === 0)
    await new Promise((done) => setTimeout(done, 50));
  await shapeUp.drawn();
  return shapeUp.state().energy.total;
}

/**
 * Loads an example and solves it, so that its energy is that of the results; returns its upward
 * axis, and its positions before and after.
 */
async function loadSolved(page, address, { id, energy: [start, end] }) {
  const isNear = (total) => Math.abs(total - end) <= 0.01 * end + 1e-9 * start;
  // A run is the fastest and meets hard constraints, but has no limit.
  for (const isLimited of [false, true]) {
    await load(page, address, `#example=${id}`);
    const positions = () => page.evaluate(() => [...window.shapeUp.positions()]);
    const { solver, up = 'z' } = await page.evaluate(() => window.shapeUp.scene());
    const before = await positions();
    // Drawing in software takes longer than solving.
    await page.setViewportSize(TINY);
    const total = await page.evaluate(solve, isLimited ? (solver?.iterations ?? 200) : 0);
    await page.setViewportSize(windowOf());
    if (isNear(total)) return { up, points: [...before, ...(await positions())] };
  }
  throw new Problem(`${id}: the page does not get the energy ${end} of its results`);
}

/** Takes both pictures of an example with the same camera, which the page `framing` finds. */
async function takeSolved({ page, framing }, address, result) {
  const { up, points } = await loadSolved(page, address, result);
  const camera = await cameraFor(framing, points, up);
  await look(page, camera);
  await write(`${result.id}-end`, page, CARD_PICTURE);
  await load(page, address, `#example=${result.id}`);
  await look(page, camera);
  await write(`${result.id}-start`, page, CARD_PICTURE);
}

/** Takes the pictures of an example without constraints: its end is its flat map. */
async function takeFlattened({ page }, address, { id }) {
  await load(page, address, `#example=${id}`);
  await write(`${id}-start`, page, CARD_PICTURE);
  // The map has a half of the view.
  await page.setViewportSize(windowOf(2));
  await page.evaluate(() => document.querySelector('[data-command=parametrize]').click());
  const map = page.getByRole('application', { name: 'Flat map' });
  await map.waitFor();
  const scale = CARD_PICTURE.width / CARD.width;
  const part = await map.evaluate((element, factor) => {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = element;
    return [offsetLeft, offsetTop, offsetWidth, offsetHeight].map((side) =>
      Math.round(side * factor),
    );
  }, scale);
  await write(`${id}-end`, page, { ...CARD_PICTURE, width: 2 * CARD_PICTURE.width, part });
  await page.setViewportSize(windowOf());
}

/** Returns the results of all examples, or of one. */
function resultsOf(only) {
  const results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
  const found = results.filter(({ id }) => !only || id === only);
  const ids = () => results.map(({ id }) => id).join(', ');
  if (found.length === 0) throw new Problem(`example=${only}: not known; there are ${ids()}`);
  return found;
}

/** Takes the pictures of examples. */
async function takeGallery(browser, address, results) {
  const [page, framing] = await Promise.all(
    [0, 1].map(() => browser.newPage({ viewport: windowOf() })),
  );
  page.on('pageerror', (error) => console.error(error));
  await load(framing, address);
  for (const result of results)
    await (result.energy ? takeSolved : takeFlattened)({ page, framing }, address, result);
}

/** Solves the examples and writes the results that the gallery shows. */
const solveExamples = () =>
  run(
    'cargo',
    ['test', '--locked', '--quiet', '--features', 'view', '--test', 'native', 'gallery'],
    { env: { UPDATE: '1' } },
  );

await main(async () => {
  const [onlyFirst, onlyReadme] = ['first', 'readme'].map((word) => process.argv.includes(word));
  const only = process.argv.find((word) => word.startsWith('example='))?.slice('example='.length);
  if (!onlyFirst && !onlyReadme && !only) {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder);
    say('solving the examples for their results');
    await solveExamples();
  }
  const results = resultsOf(only);
  const { address, close } = await serve(at('dist'), { port: 4273 });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: webgl2Flags,
  });
  try {
    if (onlyReadme) return await takeReadme(browser, address);
    if (!only) {
      say('taking pictures of the first screen');
      await takeFirst(browser, address);
    }
    if (onlyFirst) return;
    say('taking pictures of the gallery');
    await takeGallery(browser, address, results);
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
