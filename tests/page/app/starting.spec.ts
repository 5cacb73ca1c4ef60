// If a part of the page cannot be loaded, one plain message gives the reason and the suggestion, and no
// later error covers it.

import { readdirSync } from 'node:fs';
import { at } from '../../../.scripts/project.mjs';
import { expect, test } from '../support.ts';

test.use({ fresh: true });

const SUGGESTION = 'Check the network, then reload the page.';

/** What is missing, how it fails, and the message shown. */
const FAILURES: Record<string, { missing: string; status?: number; words: string }> = {
  'the script of the page is not there': {
    missing: '**/assets/workbench-*.js',
    status: 404,
    words: `Shape-Up could not be started (a part of the page could not be fetched). ${SUGGESTION}`,
  },
  'the module of words is not there': {
    missing: '**/assets/words-*.wasm',
    status: 404,
    words: `Shape-Up could not be started (a part of the page could not be fetched). ${SUGGESTION}`,
  },
  'the network fails at the module of words': {
    missing: '**/assets/words-*.wasm',
    words: `Shape-Up could not be started (a part of the page could not be fetched). ${SUGGESTION}`,
  },
  "the solver's module is not there": {
    missing: '**/assets/engine-*.wasm',
    status: 404,
    words: `The solver could not be started (its module could not be fetched: 404). ${SUGGESTION}`,
  },
  "the network fails at the solver's module": {
    missing: '**/assets/engine-*.wasm',
    words: `The solver could not be started (its module could not be fetched). ${SUGGESTION}`,
  },
  "the solver's worker is not there": {
    missing: '**/assets/solver-worker-*.js',
    status: 404,
    words: `The solver could not be started (its worker could not be fetched). ${SUGGESTION}`,
  },
};

/** Expects no complaints other than those about what is missing. */
function expectOnlyMissing(complaints: string[]) {
  const missing = /net::ERR_FAILED|404|a part of the page could not be fetched/;
  expect(complaints.filter((text) => !missing.test(text))).toEqual([]);
  complaints.length = 0;
}

for (const [title, { missing, status, words }] of Object.entries(FAILURES)) {
  test(`${title}: the message appears and stays`, async ({ page, complaints }) => {
    await page.route(missing, (route) => (status ? route.fulfill({ status }) : route.abort()));
    await page.goto('./');
    const message = page.getByRole('alert').getByRole('paragraph');
    await expect(message).toHaveText(words);
    // Without its script the page's buttons do nothing.
    if (await page.evaluate(() => Boolean(window.shapeUp))) {
      // Requests made meanwhile fail without covering the message.
      const refused = await page.evaluate(() =>
        window.shapeUp.open('v 0 0 0', 'a.obj').catch(({ message }) => message),
      );
      expect(refused).toContain('the solver');
      await expect(message).toHaveText(words);
      await page.unroute(missing);
      await page.getByRole('alert').getByRole('button', { name: 'Reload' }).click();
      await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
    }
    expectOnlyMissing(complaints);
  });
}

test('a view that could not be fetched is not reported as missing graphics support', async ({
  page,
  complaints,
}) => {
  await page.route('**/assets/view-web*.wasm', (route) => route.fulfill({ status: 404 }));
  await page.goto('./');
  await expect(page.getByText('the drawing module could not be loaded')).toBeVisible();
  await expect(page.getByText(SUGGESTION)).toBeVisible();
  expect(complaints.filter((text) => !/404/.test(text))).toEqual([]);
  complaints.length = 0;
});

test('the gallery without the module of words says why it is empty', async ({
  page,
  complaints,
}) => {
  await page.route('**/assets/words-*.wasm', (route) => route.abort());
  await page.goto('./gallery.html');
  await expect(page.getByRole('alert')).toHaveText(
    `This page could not be started (a part of the page could not be fetched). ${SUGGESTION}`,
  );
  await expect(page.getByText('Loading')).toHaveCount(0);
  expectOnlyMissing(complaints);
});

test('each page of the site begins with one script', async ({ request }) => {
  // In Safari the workbench did not start: of three scripts, the last did not wait for the module of
  // words, which another awaited.
  const pages = readdirSync(at('dist')).filter((name) => name.endsWith('.html'));
  expect(pages).toContain('index.html');
  for (const page of pages) {
    const text = await (await request.get(`./${page}`)).text();
    expect([page, ...text.match(/<script[^>]* type="module"[^>]*>/g)!.slice(1)]).toEqual([page]);
  }
});
