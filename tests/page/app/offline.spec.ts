// Use without a network, and updates to a new version.

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import { at } from '../../../.scripts/project.mjs';
import { serve } from '../../../.scripts/serve.mjs';
import { downloaded, exported, openExample, runToTheEnd, showStep, tool } from '../actions.ts';
import { expect, keptOffline, state, test, visit, waitForState } from '../support.ts';

declare global {
  interface Window {
    /** Set in the page before a reload. */
    isOld?: boolean;
  }
}

test.use({ fresh: true, serviceWorkers: 'allow' });

test('after one visit the page works without a network', async ({ page, context, complaints }) => {
  await visit(page);
  await keptOffline(page);
  // Of the pictures of the first screen, that which was shown.
  const pictures = await page.evaluate(async () => {
    const kept = await Promise.all(
      (await caches.keys()).map(async (name) => (await caches.open(name)).keys()),
    );
    return kept.flat().flatMap(({ url }) => /first-[a-z]+-[a-z]+/.exec(url) ?? []);
  });
  expect(pictures).toEqual(['first-wide-light']);
  await context.setOffline(true);
  await visit(page);
  await waitForState(page, (now) => now.converged);
  await page.getByRole('button', { name: 'Reset' }).click();
  await waitForState(page, (now) => now.iteration === 0);
  const after = await runToTheEnd(page);
  expect(after.iteration).toBeGreaterThan(0);
  await openExample(page, 'Hypar');
  // An address with a parameter is served from the cache too.
  await visit(page, `renderer=${(await state(page)).renderer}`);
  expect((await state(page)).vertices).toBeGreaterThan(0);
  // Only the gallery has the pictures of the menu kept.
  expect(complaints.filter((text) => !/pictures\/[\w-]+-end\.webp/.test(text))).toEqual([]);
  complaints.length = 0;
});

test('parts are built and saved without a network even if Build was never opened before', async ({
  page,
  context,
}) => {
  await visit(page);
  await keptOffline(page);
  await context.setOffline(true);
  await visit(page);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  const { build } = await waitForState(page, (now) => now.build !== null);
  const save = page.getByRole('button', { name: 'Save drawings' });
  const { name, bytes } = await downloaded(page, () => save.click());
  expect(name).toMatch(/-parts\.zip$/);
  const drawings = Object.keys(unzipSync(bytes)).filter((file) => file.endsWith('.dxf'));
  expect(drawings).toHaveLength(build?.sheets ?? NaN);
});

test('after one visit the gallery has all its pictures without a network', async ({
  page,
  context,
}) => {
  await visit(page);
  await keptOffline(page);
  const openGallery = async () => {
    await page.goto('./gallery.html');
    await expect(page.getByRole('article').first()).toBeVisible();
  };
  await openGallery();
  const addresses = await page
    .getByRole('article')
    .getByRole('img')
    .evaluateAll((all: HTMLImageElement[]) => all.filter(({ src }) => src).map(({ src }) => src));
  expect(addresses.length).toBeGreaterThan(50);
  const missing = () =>
    page.evaluate(async (wanted) => {
      const kept = await Promise.all(wanted.map((address) => caches.match(address)));
      return kept.filter((one) => !one).length;
    }, addresses);
  await expect.poll(missing).toBe(0);
  await context.setOffline(true);
  await openGallery();
  // The last picture is far below the visible part.
  const last = page.locator(`img[src="${addresses.at(-1)}"]`);
  await last.scrollIntoViewIfNeeded();
  await expect
    .poll(() => last.evaluate((image: HTMLImageElement) => image.naturalWidth))
    .toBeGreaterThan(100);
  // They are there in the menu of examples, too.
  await visit(page);
  await tool(page, 'Examples');
  const item = page.getByRole('menuitem', { name: 'Hypar' }).locator('img').first();
  await item.scrollIntoViewIfNeeded();
  await expect
    .poll(() => item.evaluate((image: HTMLImageElement) => image.naturalWidth))
    .toBeGreaterThan(100);
});

test('with full storage, parts loaded later still come from the network', async ({
  page,
  context,
}) => {
  await visit(page);
  await keptOffline(page);
  const session = await context.newCDPSession(page);
  const { origin } = new URL(page.url());
  await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 1 });
  const rhino = await exported(page, '3DM');
  expect(rhino.bytes.subarray(0, 22).toString()).toBe('3D Geometry File Forma');
  // Confirms that the storage was full: nothing of rhino3dm was cached.
  const kept = await page.evaluate(async () => {
    const caught = await Promise.all((await caches.keys()).map((name) => caches.open(name)));
    const requests = await Promise.all(caught.map((cache) => cache.keys()));
    return requests.flat().filter(({ url }) => url.includes('rhino')).length;
  });
  expect(kept).toBe(0);
});

/** Hosts a copy of the site whose version can be changed. */
const hosted = test.extend<{ host: { address: string; folder: string } }>({
  // eslint-disable-next-line no-empty-pattern
  host: async ({}, use) => {
    const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
    cpSync(at('dist'), folder, { recursive: true });
    const { address, close } = await serve(folder, { port: 5100, base: '/deep/below/' });
    await use({ address, folder });
    close();
    rmSync(folder, { recursive: true });
  },
});

hosted('a new version is announced and waits until the user reloads', async ({ page, host }) => {
  const open = async () => {
    await page.goto(host.address);
    await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
  };
  await open();
  await keptOffline(page);
  const worker = join(host.folder, 'service-worker.js');
  const next = readFileSync(worker, 'utf8').replace(/"version":"\w+"/, '"version":"next"');
  writeFileSync(worker, next);
  await open();
  const news = page.getByRole('alert').getByText('A new version of Shape-Up is available');
  await expect(news).toBeVisible();
  const versions = () =>
    page.evaluate(async () => (await caches.keys()).filter((name) => name.startsWith('shape-up')));
  expect(await versions()).toHaveLength(2);
  const waiting = () =>
    page.evaluate(async () => Boolean((await navigator.serviceWorker.ready).waiting));
  expect(await waiting()).toBe(true);
  await page.evaluate(() => (window.isOld = true));
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction(() => !window.isOld && window.shapeUp?.state().vertices > 0);
  expect(await waiting()).toBe(false);
  await expect(news).toBeHidden();
});

test('the page can be installed as an app', async ({ page, context }) => {
  await visit(page);
  const session = await context.newCDPSession(page);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  // Tests run in an incognito window.
  const serious = installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito');
  expect(serious).toEqual([]);
  const { errors } = await session.send('Page.getAppManifest');
  expect(errors).toEqual([]);
});
