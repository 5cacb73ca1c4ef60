// npm run pictures -- readme: takes the pictures of the README through the page: the first screen; and
// a vault of triangles, circular panels along its lines of curvature, and a sheet of them.

import { writeFileSync } from 'node:fs';
import { at } from './project.mjs';

const VIEW = { width: 1440, height: 900 };
/** The size of each of the three pictures, in CSS pixels. */
const [WIDTH, HEIGHT] = [520, 346];
const CAPTIONS = [
  'A vault of triangles',
  'Circular panels along its lines of curvature',
  'Sheets to cut',
];

/** Returns numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 7;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647 - 0.5;
  };
}

/** The text of an OBJ file of a vault over a bent axis, wide at its ends, of irregular triangles. */
export function vaultOfTriangles(along = 44, across = 26) {
  const next = random();
  const point = (u, v) => {
    const [turn, flare] = [0.9 * (u - 0.5), (2 * u - 1) ** 2];
    const [half, rise] = [5.2 + 2.6 * flare, 4.2 + 1.6 * flare - 0.8 * u];
    const [side, height] = [half * Math.sin(1.5 * v), rise * Math.cos(1.5 * v)];
    const radius = 30 / 0.9;
    return [(radius - side) * Math.sin(turn), radius - (radius - side) * Math.cos(turn), height];
  };
  const lines = [];
  for (let i = 0; i <= along; i++)
    for (let j = 0; j <= across; j++) {
      // Those of the boundary stay on it.
      const shift = (k, most) => (k === 0 || k === most ? k : k + 0.6 * next()) / most;
      const place = point(shift(i, along), 2 * shift(j, across) - 1);
      lines.push(`v ${place.map((x) => x.toFixed(4)).join(' ')}`);
    }
  for (let i = 0; i < along; i++)
    for (let j = 0; j < across; j++) {
      const a = i * (across + 1) + j + 1;
      const [b, c, d] = [a + across + 1, a + across + 2, a + 1];
      if (next() < 0) lines.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
      else lines.push(`f ${a} ${b} ${d}`, `f ${b} ${c} ${d}`);
    }
  return `${lines.join('\n')}\n`;
}

/** A picture of the view in a page, as a data URL. */
async function pictureOf(page) {
  await page.evaluate(() => window.shapeUp.drawn());
  return page.evaluate(async (width) => {
    const taken = await window.shapeUp.picture({ width, ground: 'view', legend: false });
    return new Promise((done) => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result);
      reader.readAsDataURL(taken);
    });
  }, 2 * WIDTH);
}

/** Makes panels of the vault and a sheet as a user does; returns the three pictures as data URLs. */
async function walk(page, address) {
  await page.goto(address);
  await page.waitForFunction(() => window.shapeUp?.state().converged);
  await page.evaluate((text) => window.shapeUp.open(text, 'vault.obj'), vaultOfTriangles());
  // The proportions of a picture are those of the view.
  const pictures = [await pictureOf(page)];
  const camera = await page.evaluate(() => window.shapeUp.camera());

  await page.getByRole('button', { name: 'New panels along the curvature' }).click();
  const card = page.getByRole('region', { name: 'New panels' });
  await card.getByLabel('Then').selectOption('Make panels circular');
  await card.getByRole('button', { name: 'Use these panels' }).click({ timeout: 60_000 });
  await page.waitForFunction(() => {
    const { running, exact, faces, constraints } = window.shapeUp.state();
    return !running && exact?.met && constraints.circle === faces;
  });
  await page.evaluate((it) => window.shapeUp.look(it), camera);
  pictures.push(await pictureOf(page));

  await page.getByRole('button', { name: 'Build', exact: true }).click();
  const sheet = page.getByRole('region', { name: 'Parts and sheets' }).getByRole('img').first();
  await sheet.waitFor();
  // Over all of a window of the size of the picture, in which its lines are as wide as elsewhere.
  await page.setViewportSize({ width: WIDTH, height: HEIGHT });
  await sheet.evaluate((drawing) => {
    const whole = { position: 'fixed', inset: '0', width: '100%', height: '100%', zIndex: '9' };
    Object.assign(drawing.style, whole, { maxHeight: 'none', background: '#fff' });
  });
  const drawn = await page.screenshot({ type: 'png' });
  return [...pictures, `data:image/png;base64,${drawn.toString('base64')}`];
}

/** Writes a picture of a page into the folder of the README's pictures. */
async function write(name, page) {
  writeFileSync(at('.github', `${name}.png`), await page.screenshot({ type: 'png' }));
  await page.close();
}

/** The first screen, once the first visit's hint is dismissed. */
async function takePage(browser, address) {
  const page = await browser.newPage({ viewport: VIEW, colorScheme: 'light' });
  await page.goto(address);
  await page.waitForFunction(() => window.shapeUp?.state().converged);
  await page.locator('#hint-card').getByRole('button').click();
  await page.evaluate(() => window.shapeUp.drawn());
  await write('picture', page);
}

async function takeStory(browser, address) {
  const page = await browser.newPage({
    viewport: VIEW,
    colorScheme: 'light',
    deviceScaleFactor: 2,
  });
  const pictures = await walk(page, address);
  const figures = pictures.map(
    (picture, k) =>
      `<figure><img src="${picture}"><figcaption>${CAPTIONS[k]}</figcaption></figure>`,
  );
  const sheet = await browser.newPage({ viewport: { width: 3 * WIDTH + 80, height: HEIGHT + 74 } });
  await sheet.setContent(`<style>
    body { margin: 0; display: flex; gap: 20px; padding: 16px 20px; background: #fff; font: 17px system-ui; }
    figure { margin: 0; width: ${WIDTH}px; }
    img { width: 100%; height: ${HEIGHT}px; object-fit: cover; }
    figcaption { margin-top: 10px; text-align: center; color: #333; }
  </style>${figures.join('')}`);
  await page.close();
  await write('story', sheet);
}

/** Takes both. */
export async function takeReadme(browser, address) {
  await takePage(browser, address);
  await takeStory(browser, address);
}
