// Without a network, and when there is a new version.

import { readFileSync } from 'node:fs';
import { openExample, runToTheEnd } from './actions.mjs';
import { expect, openPage, state, test } from './support.mjs';

test.use({ serviceWorkers: 'allow' });

const WORKER = new URL('../../dist/service-worker.js', import.meta.url);

/** Waits until the built files are kept and the service worker answers for them. */
async function keptOffline(page) {
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
}

test('after one visit the page works without a network', async ({ page, context }) => {
  await openPage(page);
  await keptOffline(page);
  await context.setOffline(true);
  await openPage(page);
  const after = await runToTheEnd(page);
  expect(after.iteration).toBeGreaterThan(0);
  await openExample(page, 'Hypar');
  // A parameter of the address does not lead out.
  await openPage(page, 'backend=webgl2');
  expect((await state(page)).vertices).toBeGreaterThan(0);
});

test('a new version is announced and waits until it is wanted', async ({ page, context }) => {
  await openPage(page);
  await keptOffline(page);
  const next = readFileSync(WORKER, 'utf8').replace(/"version":"\w+"/, '"version":"next"');
  await context.route('**/service-worker.js', (route) =>
    route.fulfill({ contentType: 'text/javascript', body: next }),
  );
  await openPage(page);
  const news = page.getByRole('alert').getByText('A new version of Shape-Up is here');
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

test('it can be installed', async ({ page, context }) => {
  await openPage(page);
  const session = await context.newCDPSession(page);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  // A test runs in a window without a history.
  const serious = installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito');
  expect(serious).toEqual([]);
  const { errors } = await session.send('Page.getAppManifest');
  expect(errors).toEqual([]);
});
