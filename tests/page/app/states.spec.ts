// States of the page with large files, without a network, without a model, or with a stopped
// solver. Other states are tested with the features that lead to them.

import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { at } from '../../../.scripts/project.mjs';
import { openText, showStep, tool } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { expect, openPage, settled, state, test, waitForState } from '../support.ts';

declare global {
  interface Window {
    /** What has been announced. */
    heard: string[];
    /** Lets the rest of a file be read. */
    goOn(): void;
  }
}

const status = (page: Page) => page.getByRole('status');
const card = (page: Page) => page.getByRole('group', { name: /^Opening / });

/** A file with more faces than stay interactive, cheap to draw: one small face repeated. */
const large = (faces: number) =>
  [wavyGrid(2), 'v 1 1 0\nv 1.01 1 0\nv 1.01 1.01 0\n', 'f 10 11 12\n'.repeat(faces - 4)]
    .join('')
    .padEnd(2_100_000, '#\n');

/** Returns the announcements made during `action`, in order. */
async function heard(page: Page, action: () => Promise<void>) {
  await page.evaluate(() => {
    window.heard = [];
    const place = document.querySelector('[role=status]') as Element;
    const listen = () => window.heard.push(place.textContent);
    new MutationObserver(listen).observe(place, {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  await action();
  return page.evaluate(() => window.heard);
}

test('without scripts the page shows an explanation and a link', async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL });
  const page = await context.newPage();
  await page.goto('./');
  const words = page.locator('.no-script');
  await expect(words).toBeVisible();
  await expect(words.locator('a')).toHaveAttribute('href', /doi\.org/);
  await context.close();
});

test('a slowly loading solver shows its progress', async ({ page }) => {
  const module = readFileSync(at('www', 'pkg', 'engine', 'shape_up_bg.wasm'));
  const middle = module.length / 2;
  let goOn!: () => void;
  const host = createServer(async (_, answer) => {
    answer.writeHead(200, { 'Content-Type': 'application/wasm' });
    answer.write(module.subarray(0, middle));
    // Waits longer than the delay before the progress is shown, then sends one byte, which is
    // reported.
    await new Promise((done) => setTimeout(done, 1500));
    answer.write(module.subarray(middle, middle + 1));
    await new Promise<void>((done) => (goOn = done));
    answer.end(module.subarray(middle + 1));
  });
  await new Promise<void>((done) => host.listen(0, '127.0.0.1', done));
  const { port } = host.address() as AddressInfo;
  const url = `http://127.0.0.1:${port}/`;
  await page.route('**/{engine,view}-*.wasm', async (route) => {
    const response = await route.fetch();
    const isSolver = (await response.body()).length === module.length;
    return isSolver ? route.continue({ url }) : route.fulfill({ response });
  });
  await page.goto('./');
  await expect(page.getByText(/^Loading the solver · \d\.\d of \d\.\d MB$/)).toBeVisible();
  goOn();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.getByText(/^Loading the solver/)).toBeHidden();
  host.close();
});

test('running, paused and converged are each announced once', async ({ page }) => {
  await openPage(page);
  await expect(status(page)).toHaveText(/^Opened the example/);
  const words = await heard(page, async () => {
    await page.getByRole('button', { name: 'Run' }).click();
    await expect(status(page)).toHaveText(/^Converged after \d+ iterations$/);
    await waitForState(page, (now) => !now.running);
  });
  expect(words).toEqual(['Running', expect.stringMatching(/^Converged after/)]);
  await expect(page.getByRole('button', { name: 'Run' })).toBeVisible();
});

test('if no example can be fetched, the page shows what can be opened', async ({
  page,
  complaints,
}) => {
  await page.route('**/examples/*', (route) => route.abort());
  await page.goto('./');
  await expect(page.getByText(/^Drop a mesh \(\.obj, .*\) or a scene/)).toBeVisible();
  await expect(page.locator('#first-picture')).toHaveCount(0);
  await showStep(page, 'Open');
  await expect(page.getByText('Nothing is open.')).toBeVisible();
  // Other items are there all the same.
  const items = page.getByRole('menu', { name: 'Examples' }).getByRole('menuitem');
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await expect(items).toHaveText([/^New mesh/, /^Gallery/]);
  await page.keyboard.press('Escape');
  await page.unroute('**/examples/*');
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await expect.poll(() => items.count()).toBeGreaterThan(5);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Open an example' }).click();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.getByText(/^Drop a mesh \(\.obj, .*\) or a scene/)).toBeHidden();
  // The hints of the first visit are about it.
  await expect(page.getByText(/Drag a blue handle/).filter({ visible: true })).not.toHaveCount(0);
  const shapes = page.getByRole('checkbox', { name: 'Best-fitting shapes' });
  await expect(shapes).toBeChecked();
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await expect(shapes).not.toBeChecked();
  // The only complaints are about the blocked requests.
  expect(complaints.filter((text) => !text.includes('net::ERR_FAILED'))).toEqual([]);
  complaints.length = 0;
});

test('a large file shows its progress, and reading can be cancelled', async ({ page }) => {
  await page.addInitScript(() => {
    const { stream } = Blob.prototype;
    // Every file gives its first half at once and the rest on demand.
    const wanted = new Promise<void>((go) => (window.goOn = go));
    Blob.prototype.stream = function () {
      const [half, rest] = [this.slice(0, this.size / 2), this.slice(this.size / 2)];
      const parts = [half, rest].map((part) => stream.call(part).getReader());
      let at = 0;
      const pull = async (
        controller: ReadableStreamDefaultController<Uint8Array<ArrayBuffer>>,
      ): Promise<void> => {
        const { done, value } = await parts[at].read();
        if (!done) return controller.enqueue(value);
        if (++at === 2) return controller.close();
        await wanted;
        return pull(controller);
      };
      return new ReadableStream({ pull });
    };
  });
  await openPage(page);
  const before = await state(page);
  const open = () => page.getByLabel('Open file').setInputFiles(file('wide.obj', large(2000)));
  await open();
  await expect(card(page)).toContainText(/Reading wide\.obj · 1\.\d of 2\.1 MB/);
  await expect(card(page).getByRole('progressbar')).toHaveJSProperty('max', 1);
  await card(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toHaveText('Cancelled');
  expect((await state(page)).vertices).toBe(before.vertices);

  await open();
  await expect(card(page)).toContainText(/1\.\d of 2\.1 MB/);
  await page.evaluate(() => window.goOn());
  await waitForState(page, (now) => now.vertices === 12);
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toHaveText(/^Opened wide\.obj/);
});

test('Cancel while a Rhino file is converted leaves the solver at its work', async ({ page }) => {
  // It was ended, and with it the run of the open model.
  await page.route('**/assets/rhino-worker-*.js', () => {});
  await openPage(page);
  const solver = () => page.workers().filter((worker) => worker.url().includes('solver-worker'));
  const [before] = solver();
  expect(before).toBeDefined();
  const rhino = file('roof.3dm', ' '.repeat(2_100_000));
  await page.getByLabel('Open file').setInputFiles(rhino);
  await expect(card(page)).toContainText('Opening roof.3dm');
  await card(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toHaveText('Cancelled');
  await settled(page);
  expect(solver()).toHaveLength(1);
  expect(solver()[0]).toBe(before);
});

/** Replaces the interactive limit that the solver reports, which differs between machines. */
const interactiveUpTo = (page: Page, most: number) =>
  page.addInitScript((value) => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      if (message.name !== 'mostFaces') return Reflect.apply(postMessage, this, [message, ...rest]);
      const data = { type: 'reply', id: message.id, value };
      this.dispatchEvent(new MessageEvent('message', { data }));
    };
  }, most);

test('the limit estimated for this machine is a round number within bounds', async ({ page }) => {
  await openPage(page);
  // Larger than any limit.
  await page.getByLabel('Open file').setInputFiles(file('city.obj', large(600_000)));
  await expect(card(page)).toContainText(
    /600.000 faces\. Shape-Up stays interactive up to about [1-9]\d{0,2}(.?000)+ on this computer/,
  );
  await card(page).getByRole('button', { name: 'Cancel' }).click();
});

test('a mesh too large for the machine opens only after confirmation', async ({ page }) => {
  await interactiveUpTo(page, 12_000);
  await openPage(page);
  const before = await state(page);
  const open = () => page.getByLabel('Open file').setInputFiles(file('city.obj', large(60_000)));
  await open();
  await expect(card(page)).toContainText(
    /60.?000 faces\. Shape-Up stays interactive up to about 12.?000 on this computer/,
  );
  // The question is announced too, and its answer has the focus.
  await expect(status(page)).toHaveText(/^city\.obj: 60.000 faces$/);
  const anyway = page.getByRole('button', { name: 'Load anyway' });
  await expect(anyway).toBeFocused();
  await expect(anyway).toHaveAccessibleDescription(/stays interactive up to about/);
  await page.keyboard.press('Escape');
  await expect(card(page)).toBeHidden();
  expect((await state(page)).faces).toBe(before.faces);
  await expect(page.getByRole('alert')).toBeEmpty();

  // The question is gone with another file that is opened meanwhile: Load anyway had no effect then.
  await open();
  await expect(anyway).toBeVisible();
  // Commands are about the open model meanwhile.
  await tool(page, 'More formats');
  await expect(page.getByRole('dialog', { name: 'More formats' })).toBeVisible();
  await page.keyboard.press('Escape');
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toContainText('Opened grid');

  // A new mesh takes the place of the question, and the open model comes back without it.
  await open();
  await expect(anyway).toBeVisible();
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const drawn = page.getByRole('dialog', { name: 'New mesh' });
  await expect(drawn).toBeVisible();
  await drawn.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now) => now.vertices === 25);
  await expect(card(page)).toBeHidden();

  await open();
  await page.getByRole('button', { name: 'Load anyway' }).click();
  await waitForState(page, (now) => now.faces === 60_000);
});

test('opening a file can be cancelled while the solver builds the model', async ({ page }) => {
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    // The solver never answers for this file.
    Worker.prototype.postMessage = function (message, ...rest) {
      const isIt = message.name === 'open' && message.given[0].files[0].name === 'wide.obj';
      if (!isIt) Reflect.apply(postMessage, this, [message, ...rest]);
    };
  });
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await page.getByLabel('Open file').setInputFiles(file('wide.obj', large(2000)));
  await expect(card(page)).toContainText('Opening wide.obj');
  // Meanwhile another one can be chosen.
  await tool(page, 'Open recent');
  await expect(page.getByRole('menu', { name: 'Open recent' })).toBeVisible();
  await page.keyboard.press('Escape');
  await card(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toHaveText('Cancelled');
  await expect(page.getByRole('alert')).toBeEmpty();
  // The solver works again, with the previous model.
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (now) => now.iteration === 1 && now.vertices === 25);
});

test('a crashed solver leaves a report that can be copied', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page);
  const [worker] = page.workers();
  await worker.evaluate(() => {
    setTimeout(() => {
      throw new Error('out of order');
    });
  });
  await expect(page.getByRole('alert')).toContainText('was restarted');
  await page.getByRole('button', { name: 'Copy report' }).click();
  await expect(status(page)).toHaveText('Report copied to the clipboard');
  const report = await page.evaluate(() => navigator.clipboard.readText());
  const { vertices } = await state(page);
  for (const part of ['out of order', `${vertices} vertices`, 'Iteration: 0', 'Browser: '])
    expect(report).toContain(part);
});

test('a missing graphics card is noted quietly; going offline and online is each announced once', async ({
  page,
  context,
}) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const note = page.locator('#numbers').getByText('Software rendering');
  // The tests draw in software; a narrow window has no room for the note.
  await expect(note).toBeAttached();
  await expect(note.locator('..')).toHaveAttribute('title', /acceleration/);
  await expect(page.getByRole('alert')).toBeEmpty();

  await expect(page.getByText('Offline', { exact: true })).toBeHidden();
  const words = await heard(page, async () => {
    await context.setOffline(true);
    await expect(page.getByText('Offline', { exact: true })).toBeVisible();
    await context.setOffline(false);
    await expect(page.getByText('Offline', { exact: true })).toBeHidden();
    await expect(status(page)).toHaveText('Online again');
  });
  expect(words).toEqual([expect.stringMatching(/^Offline: /), 'Online again']);
});
