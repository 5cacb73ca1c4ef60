// The states that a page comes into with large files, without a network, without a model, or with a
// solver that has stopped. Others are in the tests of what leads to them.

import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { at } from '../../../.scripts/project.mjs';
import { openText, showPanel } from '../actions.mjs';
import { file, wavyGrid } from '../meshes.mjs';
import { expect, openPage, state, test, waitForState } from '../support.mjs';

const status = (page) => page.getByRole('status');
const card = (page) => page.getByRole('group', { name: /^Opening / });

/** More faces than can be worked with, cheap to make and to draw: the same small one again and again. */
const large = (faces) =>
  [wavyGrid(2), 'v 1 1 0\nv 1.01 1 0\nv 1.01 1.01 0\n', 'f 10 11 12\n'.repeat(faces - 4)]
    .join('')
    .padEnd(2_100_000, '#\n');

/** Everything that is said while `action` goes on, in order. */
async function heard(page, action) {
  await page.evaluate(() => {
    window.heard = [];
    const place = document.querySelector('[role=status]');
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

test('without scripts there are words and a link', async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, baseURL });
  const page = await context.newPage();
  await page.goto('./');
  const words = page.locator('.no-script');
  await expect(words).toBeVisible();
  await expect(words.locator('a')).toHaveAttribute('href', /doi\.org/);
  await context.close();
});

test('a solver that comes slowly says how much of it is here', async ({ page }) => {
  const module = readFileSync(at('www', 'pkg', 'solver', 'shape_up_bg.wasm'));
  const middle = module.length / 2;
  let goOn;
  const host = createServer(async (_, answer) => {
    answer.writeHead(200, { 'Content-Type': 'application/wasm' });
    answer.write(module.subarray(0, middle));
    // Longer than nobody waits for words; then a little more, of which it is told.
    await new Promise((done) => setTimeout(done, 1500));
    answer.write(module.subarray(middle, middle + 1));
    await new Promise((done) => (goOn = done));
    answer.end(module.subarray(middle + 1));
  });
  await new Promise((done) => host.listen(0, '127.0.0.1', done));
  const url = `http://127.0.0.1:${host.address().port}/`;
  await page.route('**/*.wasm', async (route) => {
    const response = await route.fetch();
    const isSolver = (await response.body()).length === module.length;
    return isSolver ? route.continue({ url }) : route.fulfill({ response });
  });
  await page.goto('./');
  await expect(page.getByText(/^Loading the solver · 0\.\d of 1\.\d MB$/)).toBeVisible();
  goOn();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.getByText(/^Loading the solver/)).toBeHidden();
  host.close();
});

test('running, paused and converged are each said once', async ({ page }) => {
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

test('where no example can be fetched, the page says what can be opened', async ({
  page,
  complaints,
}) => {
  await page.route('**/examples/*', (route) => route.abort());
  await page.goto('./');
  await expect(page.getByText('Drop a mesh (.obj, .off, .mesh, .3dm) or a scene')).toBeVisible();
  await expect(page.locator('#first-picture')).toHaveCount(0);
  await showPanel(page, 'Model');
  await expect(page.getByText('Nothing is open.')).toBeVisible();
  await page.unroute('**/examples/*');
  await page.getByRole('button', { name: 'Open an example' }).click();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.getByText('Drop a mesh (.obj, .off, .mesh, .3dm) or a scene')).toBeHidden();
  // The browser complains of what was held back, and of nothing else.
  expect(complaints.filter((text) => !text.includes('net::ERR_FAILED'))).toEqual([]);
  complaints.length = 0;
});

test('a large file says how far it is, and can be left while it is read', async ({ page }) => {
  await page.addInitScript(() => {
    const { stream } = Blob.prototype;
    // Half of it, and the rest when it is wanted, of every file.
    const wanted = new Promise((go) => (window.goOn = go));
    Blob.prototype.stream = function () {
      const [half, rest] = [this.slice(0, this.size / 2), this.slice(this.size / 2)];
      const parts = [half, rest].map((part) => stream.call(part).getReader());
      let at = 0;
      const pull = async (controller) => {
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
  await expect(card(page)).toContainText(/Reading wide\.obj · 1\.\d of 2\.1 MB · [\d ,]+ faces/);
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

/** What the solver says of the machine, which is not the same on every one. */
const interactiveUpTo = (page, most) =>
  page.addInitScript((value) => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      if (message.type !== 'mostFaces') return postMessage.call(this, message, ...rest);
      const data = { type: 'reply', id: message.id, value };
      this.dispatchEvent(new MessageEvent('message', { data }));
    };
  }, most);

test('what the solver says of the machine is a round number within bounds', async ({ page }) => {
  await openPage(page);
  // No file is ever so large.
  await page.getByLabel('Open file').setInputFiles(file('city.obj', large(600_000)));
  await expect(card(page)).toContainText(
    /600.000 faces\. Shape-Up stays interactive up to about [1-9]\d{0,2}(.?000)+ on this computer/,
  );
  await card(page).getByRole('button', { name: 'Cancel' }).click();
});

test('a mesh that is too large for the machine is asked about before it opens', async ({
  page,
}) => {
  await interactiveUpTo(page, 12_000);
  await openPage(page);
  const before = await state(page);
  const open = () => page.getByLabel('Open file').setInputFiles(file('city.obj', large(60_000)));
  await open();
  await expect(card(page)).toContainText(
    /60.?000 faces\. Shape-Up stays interactive up to about 12.?000 on this computer/,
  );
  // It is said too, and the answer is under the hand.
  await expect(status(page)).toHaveText(/^city\.obj: 60.000 faces$/);
  const anyway = page.getByRole('button', { name: 'Load anyway' });
  await expect(anyway).toBeFocused();
  await expect(anyway).toHaveAccessibleDescription(/stays interactive up to about/);
  await page.keyboard.press('Escape');
  await expect(card(page)).toBeHidden();
  expect((await state(page)).faces).toBe(before.faces);
  await expect(page.getByRole('alert')).toBeEmpty();

  await open();
  await page.getByRole('button', { name: 'Load anyway' }).click();
  await waitForState(page, (now) => now.faces === 60_000);
});

test('a file that has been read can still be left while the solver takes it up', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    // The solver never answers for this file.
    Worker.prototype.postMessage = function (message, ...rest) {
      const isIt = message.type === 'open' && message.files[0].name === 'wide.obj';
      if (!isIt) postMessage.call(this, message, ...rest);
    };
  });
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await page.getByLabel('Open file').setInputFiles(file('wide.obj', large(2000)));
  await expect(card(page)).toContainText('Opening wide.obj');
  await card(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(card(page)).toBeHidden();
  await expect(status(page)).toHaveText('Cancelled');
  await expect(page.getByRole('alert')).toBeEmpty();
  // The solver works again, on what was open.
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (now) => now.iteration === 1 && now.vertices === 25);
});

test('a solver that died leaves a report to copy', async ({ page, context }) => {
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

test('no graphics card is told quietly; no network is said, once, and that there is one again', async ({
  page,
  context,
}) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer !== 'none');
  const note = page.locator('#numbers').getByText('Software rendering');
  // The tests draw by software; a narrow window has no room for it.
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

test('a part of the page that cannot be fetched is told of in plain words', async ({
  page,
  complaints,
}) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer !== 'none');
  await page.route('**/split-view*', (route) => route.abort());
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('c');
  const words = 'A part of the page could not be fetched. Check the network.';
  await expect(page.getByRole('alert')).toHaveText(words);
  expect(complaints.filter((text) => !text.includes('net::ERR_FAILED'))).toEqual([]);
  complaints.length = 0;
});
