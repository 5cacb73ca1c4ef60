// The page embedded in another one: it starts on request, stores nothing, uses the wheel only while
// it is active, and is controlled by messages.

import type { Page } from '@playwright/test';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import jsqr from 'jsqr';
import type { Answer } from '../../../www/features/embed/protocol.ts';
import { tool } from '../actions.ts';
import { decodePng } from '../picture.ts';
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

/** An answer of a view, whose result is that of any call. */
type Answered = Omit<Answer, 'result'> & { result: any };

/** Runs in the outer page: posts a call and resolves with the answer. */
const call = (page: Page, id: string, asked: { name: string; [argument: string]: unknown }) =>
  page.evaluate(
    ([frame, body]) =>
      new Promise<Answered>((done) => {
        const { contentWindow } = document.getElementById(frame) as HTMLIFrameElement & {
          contentWindow: Window;
        };
        const call = { shapeUp: 'call', id: Math.random(), ...body };
        addEventListener('message', ({ source, data }) => {
          if (source === contentWindow && data.id === call.id) done(data);
        });
        contentWindow.postMessage(call, '*');
      }),
    [id, asked] as const,
  );

test('a view in a page of another origin starts with a press and is controlled by messages', async ({
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
  expect((await call(page, 'a', { name: 'run' })).error).toBe('The view has not been started.');
  await a.getByRole('button', { name: 'Start the 3D model' }).click();
  const [first, second] = [await started(page, 'a'), await started(page, 'b')];
  await expect(a.getByRole('banner')).toBeHidden();
  await expect(a.getByRole('link', { name: 'Open in Shape-Up' })).toHaveAttribute(
    'href',
    /#example=hypar$/,
  );

  // The second view runs by itself, the first on request; both reach the same shape.
  await second.waitForFunction(() => window.shapeUp.state().converged);
  expect((await call(page, 'a', { name: 'state' })).result.iteration).toBe(0);
  await call(page, 'a', { name: 'run' });
  await first.waitForFunction(() => window.shapeUp.state().converged);
  const [one, other] = [
    (await call(page, 'a', { name: 'positions' })).result,
    (await call(page, 'b', { name: 'positions' })).result,
  ];
  expect(one).toEqual(other);

  // Other weights and another mesh; an impossible call is answered with an error message.
  await call(page, 'a', { name: 'weight', constraint: 0, weight: 7 });
  const { result } = await call(page, 'a', { name: 'scene' });
  expect(result.constraints[0].weight).toBe(7);
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nf 1 2 3 4\n';
  expect((await call(page, 'a', { name: 'open', text, as: 'panel.obj' })).result).toEqual({
    vertices: 4,
    faces: 1,
  });
  await call(page, 'a', { name: 'handle', vertex: 2, target: [1, 1, 1] });
  const { handles } = (await call(page, 'a', { name: 'state' })).result;
  expect(handles[0]).toMatchObject({ vertex: 2, target: [1, 1, 1] });
  expect((await call(page, 'a', { name: 'handle', vertex: 9, target: [0, 0, 0] })).error).toMatch(
    /vertex 9|vertices/,
  );
  expect((await call(page, 'a', { name: 'weight', constraint: 9, weight: 1 })).error).toMatch(
    /constraint/,
  );
  expect((await call(page, 'a', { name: 'dance' })).error).toMatch(/no call "dance"/);
  expect((await call(page, 'a', { name: 'measure', measure: 'flatness' })).error).toMatch(
    /no measure "flatness", expected null or .*planarity/,
  );
});

test('a view leaves the wheel to the outer page until it is in use', async ({
  page,
  baseURL,
  elsewhere,
}) => {
  await page.goto(
    elsewhere(
      `<iframe id="a" width="600" height="400" src="${baseURL}?embed&autoplay&measure=none#example=dome"></iframe>
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
  await call(page, 'a', { name: 'state' });
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
  browser,
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
  const context = await browser.newContext({ serviceWorkers: 'block' });
  const notes = await context.newPage();
  await notes.goto(elsewhere(line));
  const frame = notes.frameLocator('iframe');
  await frame.getByRole('button', { name: 'Start the 3D model' }).click();
  await expect(frame.getByRole('contentinfo')).toContainText('Canopy');
  await context.close();
});

test('the example page controls its two views together', async ({ page }) => {
  await page.goto('./embedding.html');
  await page.getByRole('button', { name: 'Start both' }).click();
  await started(page, 'left');
  await started(page, 'right');
  await page.getByRole('button', { name: 'Run both' }).click();
  for (const title of ['Flat panels', 'Circular panels'])
    await expect(page.getByRole('figure').filter({ hasText: title })).toContainText(
      /[1-9]\d* iter/,
    );

  const camera = (at: number) =>
    page.frames()[at].evaluate(() => window.shapeUp.screen(0)?.map(Math.round) ?? null);
  const before = await camera(2);
  const view = page.frameLocator('#left').getByRole('application', { name: '3D view' });
  await view.hover({ position: { x: 20, y: 20 } });
  await page.mouse.down();
  await page.mouse.move(300, 500, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => camera(2)).not.toEqual(before);
});

test('the example page works from another origin with only the addresses of its frames changed', async ({
  page,
  baseURL,
}) => {
  const site = new URL(baseURL ?? '');
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? '', 'http://localhost');
    const answer = await fetch(new URL(`.${pathname}`, site));
    const body = Buffer.from(await answer.arrayBuffer());
    const isPage = pathname.endsWith('.html');
    const copied = (text: string) =>
      text
        .replaceAll('src="./embed.html', `src="${site}embed.html`)
        .replace("frame-src 'self'", `frame-src ${site.origin}`);
    response
      .writeHead(answer.status, { 'content-type': answer.headers.get('content-type') ?? '' })
      .end(isPage ? copied(body.toString()) : body);
  });
  await page.goto(`http://localhost:${await listen(server)}/embedding.html`);
  await page.getByRole('button', { name: 'Start both' }).click();
  for (const id of ['left', 'right']) {
    const frame = await started(page, id);
    expect(await frame.evaluate(() => self.origin)).toBe(site.origin);
  }
  await page.getByRole('button', { name: 'Run both' }).click();
  for (const title of ['Flat panels', 'Circular panels'])
    await expect(page.getByRole('figure').filter({ hasText: title })).toContainText(
      /[1-9]\d* iter/,
    );
  server.closeAllConnections();
  server.close();
});
