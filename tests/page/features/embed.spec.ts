// The page embedded in another one: it starts on request, stores nothing, and uses the wheel only
// while it is active.

import type { Page } from '@playwright/test';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import jsqr from 'jsqr';
import { openText, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { decodePng, distinctColours } from '../picture.ts';
import { expect, openPage, test as base } from '../support.ts';

/** Starts a server on a free port of this machine and returns the port. */
async function listen(server: Server) {
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  return (server.address() as AddressInfo).port;
}

const test = base.extend<{ elsewhere: (text: string) => string }>({
  /** Serves a page from another origin and returns its address. */
  // eslint-disable-next-line no-empty-pattern
  elsewhere: async ({}, use) => {
    let html = '';
    const server = createServer((_, response) =>
      response.writeHead(200, { 'content-type': 'text/html' }).end(html),
    );
    const port = await listen(server);
    await use((text) => {
      html = `<!doctype html><title>Notes</title>${text}`;
      return `http://localhost:${port}/`;
    });
    server.closeAllConnections();
    server.close();
  },
});

test.use({ fresh: true });

/** Returns the frame once a model is open in it. */
async function started(page: Page, id: string) {
  const element = await page.locator(`#${id}`).elementHandle();
  const frame = await element?.contentFrame();
  if (!frame) throw new Error(`not a frame: ${id}`);
  await frame.waitForFunction(() => window.shapeUp?.state().vertices > 0);
  return frame;
}

test('until it is started a view is a picture, and fetches no module', async ({ page }) => {
  const modules: string[] = [];
  page.on('request', (request) => {
    if (/\.wasm|words-/.test(request.url())) modules.push(request.url());
  });
  await page.goto('./embed.html#example=hypar');
  const picture = page.getByRole('img', { name: 'Hypar' });
  await expect(picture).toBeVisible();
  expect(modules).toEqual([]);
  // As Start opens it: as it was made, or solved.
  await expect(picture).toHaveAttribute('src', /hypar-start/);
  await page.goto('./embed.html?solved#example=hypar&run');
  await expect(picture).toHaveAttribute('src', /hypar-end/);
});

test('a view in a page of another origin starts with a press, or plays by itself', async ({
  page,
  baseURL,
  elsewhere,
}) => {
  await page.goto(
    elsewhere(
      `<iframe id="a" width="600" height="400" src="${baseURL}?embed#example=hypar"></iframe>
       <iframe id="b" width="600" height="400" src="${baseURL}?embed&autoplay#example=hypar"></iframe>`,
    ),
  );
  const a = page.frameLocator('#a');
  await expect(a.getByRole('img', { name: 'Hypar' })).toBeVisible();
  await a.getByRole('button', { name: 'Start the 3D model' }).click();
  const [first, second] = [await started(page, 'a'), await started(page, 'b')];
  await expect(a.getByRole('banner')).toBeHidden();
  // Also once the link is made of the current scene: without the options of the embedded view.
  const link = a.getByRole('link', { name: 'Open in Shape-Up' });
  await expect(link).toHaveAttribute('href', `${baseURL}#example=hypar`);
  await link.hover();
  await first.evaluate(() => window.shapeUp.drawn());
  await expect(link).toHaveAttribute('href', `${baseURL}#example=hypar`);

  // The second view runs by itself, the first on request; both reach the same shape.
  await second.waitForFunction(() => window.shapeUp.state().converged);
  expect(await first.evaluate(() => window.shapeUp.state().iteration)).toBe(0);
  await a.getByRole('button', { name: 'Run' }).click();
  await first.waitForFunction(() => window.shapeUp.state().converged);
  const [one, other] = await Promise.all(
    [first, second].map((frame) => frame.evaluate(() => [...window.shapeUp.positions()])),
  );
  expect(one).toEqual(other);
});

test('a view leaves the wheel to the outer page until it is in use', async ({
  page,
  baseURL,
  elsewhere,
}) => {
  await page.goto(
    elsewhere(
      `<iframe id="a" width="600" height="400" src="${baseURL}embed.html?embed&autoplay&measure=none#example=dome"></iframe>
       <p style="height: 3000px">Notes</p>`,
    ),
  );
  const frame = await started(page, 'a');
  await frame.waitForFunction(() => window.shapeUp.state().converged);
  const view = page.frameLocator('#a').getByRole('application', { name: '3D view' });
  await view.hover();
  await page.mouse.wheel(0, 240);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);

  await page.evaluate(() => scrollTo(0, 0));
  await view.click({ position: { x: 12, y: 12 } });
  await page.mouse.wheel(0, 240);
  await frame.evaluate(() => window.shapeUp.drawn());
  expect(await page.evaluate(() => scrollY)).toBe(0);
});

test('a view never stores anything', async ({ page }) => {
  // A browser may deny storage to a frame of another site; here storage is available.
  await page.goto('./?embed&autoplay#example=dome');
  await page.waitForFunction(() => window.shapeUp?.state().converged);
  await page.getByRole('button', { name: 'Reset' }).click();
  await page.waitForFunction(() => window.shapeUp.state().iteration === 0);
  expect(
    await page.evaluate(async () => ({
      local: Object.keys(localStorage),
      session: Object.keys(sessionStorage),
      databases: (await indexedDB.databases()).length,
      workers: (await navigator.serviceWorker.getRegistrations()).length,
    })),
  ).toEqual({ local: [], session: [], databases: 0, workers: 0 });
});

test('Share gives the HTML that embeds the model, and a QR code of the link', async ({
  page,
  otherPage,
  elsewhere,
}) => {
  await openPage(page);
  await tool(page, 'Share');
  const dialog = page.getByRole('dialog', { name: 'Share' });
  const link = await dialog.getByRole('textbox', { name: 'Link' }).inputValue();
  const picture = await dialog.getByRole('img', { name: 'QR code' }).screenshot();
  const { pixels, width, height, channels } = decodePng(picture);
  const opaque = Uint8ClampedArray.from({ length: 4 * width * height }, (_, i) =>
    i % 4 === 3 ? 255 : pixels[channels * (i >> 2) + (i % 4)],
  );
  expect(jsqr(opaque, width, height)?.data).toBe(link);

  const line = await dialog.getByLabel('To embed it').inputValue();
  const notes = await otherPage();
  await notes.goto(elsewhere(line));
  const frame = notes.frameLocator('iframe');
  await frame.getByRole('button', { name: 'Start the 3D model' }).click();
  await expect(frame.getByRole('contentinfo')).toContainText('Canopy');
});

test('a model that is no example is drawn before it is started, under its name', async ({
  page,
}) => {
  // There was an empty field.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await tool(page, 'Share');
  const dialog = page.getByRole('dialog', { name: 'Share' });
  const link = await dialog.getByRole('textbox', { name: 'Link' }).inputValue();
  await page.goto(`embed.html?embed${new URL(link).hash}`);
  const drawing = page.getByRole('img', { name: 'roof' });
  const { pixels, channels } = decodePng(await drawing.screenshot());
  const colours = new Set<string>();
  for (let at = 0; at < pixels.length; at += channels)
    colours.add(pixels.subarray(at, at + 3).join());
  expect(colours.size).toBeGreaterThan(50);
});

test('curves are drawn before they are started, too', async ({ page }) => {
  // What has no faces was an empty field.
  await openPage(page);
  await openText(page, 'curve.obj', 'v 0 0 0\nv 1 0 0\nv 2 1 0\nl 1 2 3\n', 3);
  await tool(page, 'Share');
  const dialog = page.getByRole('dialog', { name: 'Share' });
  const link = await dialog.getByRole('textbox', { name: 'Link' }).inputValue();
  await page.goto(`embed.html?embed${new URL(link).hash}`);
  const picture = decodePng(await page.getByRole('img', { name: 'curve' }).screenshot());
  expect(distinctColours(picture)).toBeGreaterThan(2);
});
