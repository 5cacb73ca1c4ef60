// npm run pictures -- readme: takes the pictures of the README through the page: the first screen; and
// a vault of triangles, circular panels along its lines of curvature, and a sheet of them.

import { writeFileSync } from 'node:fs';
import { objText } from './bench/problems.mjs';
import { at } from './project.mjs';
import { vaultTriangles } from './surfaces.mjs';

const VIEW = { width: 1440, height: 900 };
/** The size of each of the three pictures, in CSS pixels. */
const [WIDTH, HEIGHT] = [520, 346];
const CAPTIONS = [
  'A vault of triangles',
  'Circular panels along its lines of curvature',
  'Sheets to cut',
];

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
  const { points, faces } = vaultTriangles();
  const obj = objText(points, faces);
  await page.goto(address);
  await page.waitForFunction(() => window.shapeUp?.state().converged);
  await page.evaluate((text) => window.shapeUp.open(text, 'vault.obj'), obj);
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
  await page.getByRole('button', { name: 'Dismiss hint' }).click();
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
