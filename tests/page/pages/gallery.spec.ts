// The gallery: every card leads to its example, and the filters find the right ones.

import type { Page } from '@playwright/test';
import type { Example } from '../../../www/solver/examples.ts';
import { expect, known, openPage, state, test, waitForState } from '../support.ts';

// The pictures here are those of the gallery.

/** The entries of the list, as the page reads them. */
const listOf = async (page: Page): Promise<Example[]> =>
  (await page.request.get('examples/index.json')).json();

async function openGallery(page: Page) {
  await page.goto('./gallery.html');
  await expect(page.getByRole('article').first()).toBeVisible();
}

test('every example has a card with two pictures, and its start differs visibly from its end', async ({
  page,
}) => {
  const examples = await listOf(page);
  await openGallery(page);
  await expect(page.getByRole('article')).toHaveCount(examples.length);
  const first = page.getByRole('region', { name: 'To begin with' });
  await expect(first.getByRole('article')).toHaveCount(12);
  for (const { title, summary, statement, kinds } of examples) {
    const card = page.getByRole('article', { name: title, exact: true });
    await expect(card).toContainText(summary);
    await expect(card).toContainText(statement.replaceAll(/\be_([cp])\b/g, 'e$1'));
    const words = kinds.length > 0 ? 'solved' : 'as a flat map';
    for (const when of ['at the start', words])
      await expect(card.getByRole('img', { name: `${title}, ${when}` })).toHaveCount(1);
  }

  // Scales the pictures to 108 by 78 pixels and computes the fraction of pixels that differ.
  const changed = await page.evaluate(async () => {
    const pixels = async (image: HTMLImageElement) => {
      image.loading = 'eager';
      await image.decode();
      const canvas = new OffscreenCanvas(108, 78);
      const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
      context.fillStyle = '#888';
      context.fillRect(0, 0, 108, 78);
      context.drawImage(image, 0, 0, 108, 78);
      return context.getImageData(0, 0, 108, 78).data;
    };
    const parts: Record<string, number> = {};
    for (const card of document.querySelectorAll('article')) {
      const [start, end] = await Promise.all([...card.querySelectorAll('img')].map(pixels));
      let differing = 0;
      for (let k = 0; k < start.length; k += 4) {
        const by = [0, 1, 2].map((part) => Math.abs(start[k + part] - end[k + part]));
        if (Math.max(...by) > 24) differing += 1;
      }
      parts[card.id] = differing / (start.length / 4);
    }
    return parts;
  });
  expect(Object.keys(changed)).toHaveLength(examples.length);
  for (const [id, part] of Object.entries(changed)) {
    expect(part, `${id}: the part of its picture that changes`).toBeGreaterThan(0.01);
  }
});

test('examples are found by words, figures and constraints', async ({ page }) => {
  const examples = await listOf(page);
  await openGallery(page);
  const found = page.getByRole('article');
  const search = page.getByRole('searchbox', { name: 'Search' });

  await search.fill('tetrahedra BAR');
  await expect(found).toHaveCount(1);
  await expect(page.getByRole('heading', { name: 'Bent bar of rigid tetrahedra' })).toBeVisible();
  await expect(page.getByRole('status')).toHaveText('1 example');

  await search.fill('no such thing');
  await expect(found).toHaveCount(0);
  await expect(page.getByRole('status')).toContainText('No example matches');
  await expect(page.getByRole('heading', { level: 2 })).toHaveCount(0);

  await search.fill('');
  await page.getByRole('combobox', { name: 'Figure' }).selectOption('8');
  await expect(found).toHaveCount(examples.filter(({ figure }) => figure === 8).length);

  await page.getByRole('combobox', { name: 'Figure' }).selectOption('');
  const kind = page.getByRole('combobox', { name: 'Constraint' });
  await kind.selectOption({ label: 'Sphere' });
  const withSphere = examples.filter(({ kinds }) => kinds.some(({ label }) => label === 'Sphere'));
  await expect(found).toHaveCount(withSphere.length);
  expect(withSphere.length).toBeGreaterThan(1);
});

test('every card links to its example, which opens in a newly loaded page', async ({ page }) => {
  const examples = await listOf(page);
  await openGallery(page);
  const links = page.getByRole('article').getByRole('link');
  const addresses = await links.evaluateAll((all) => all.map((one) => one.getAttribute('href')));
  expect(addresses).toEqual(examples.map(({ id }) => `./#example=${id}`));
  await links.nth(4).click();
  await waitForState(page, (state, count) => state.vertices === count, examples[4].vertices);
});

/** Number of tests among which the examples are divided: some take a second or two to open. */
const PARTS = 4;
for (let part = 0; part < PARTS; part++) {
  test(`examples open one after another, part ${part + 1} of ${PARTS}`, async ({ page }) => {
    const examples = await listOf(page);
    const [first, last] = [part, part + 1].map((end) =>
      Math.floor((end * examples.length) / PARTS),
    );
    await openPage(page);
    const beside = page.getByRole('navigation', { name: 'Examples one by one' });
    for (let at = first; at < last; at++) {
      const { title, id, vertices, faces, kinds } = examples[at];
      await page.evaluate((hash) => (location.hash = hash), `#example=${id}`);
      await expect(page.getByRole('status')).toHaveText(`Opened the example ${title}`);
      const now = await state(page);
      expect([now.vertices, now.faces], id).toEqual([vertices, faces]);
      expect(Object.keys(now.constraints).sort(), id).toEqual(kinds.map((kind) => kind.id).sort());
      await expect(beside.getByRole('link', { name: 'Previous' })).toHaveCount(at > 0 ? 1 : 0);
      const isLast = at === examples.length - 1;
      await expect(beside.getByRole('link', { name: 'Next' })).toHaveCount(isLast ? 0 : 1);
    }
  });
}

test('a link opens its example in a newly loaded page, and Next goes to the following one', async ({
  page,
}) => {
  const examples = await listOf(page);
  const at = examples.findIndex(({ id }) => id === 'fig-05-circular');
  await page.goto('./#example=fig-05-circular');
  await expect(page.getByRole('status')).toHaveText(`Opened the example ${examples[at].title}`);
  await waitForState(page, (state, count) => state.vertices === count, examples[at].vertices);
  expect(new URL(page.url()).hash).toBe('#example=fig-05-circular');
  const beside = page.getByRole('navigation', { name: 'Examples one by one' });
  await beside.getByRole('link', { name: 'Next' }).click();
  await waitForState(page, (state, count) => state.vertices === count, examples[at + 1].vertices);
  await page.goBack();
  await waitForState(page, (state, count) => state.vertices === count, examples[at].vertices);
  // A model of the user's own is no example.
  await page.evaluate(() =>
    window.shapeUp.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'triangle.obj'),
  );
  await expect(beside).toBeHidden();
});

test('a link to an unknown example shows a message and opens the first example', async ({
  page,
}) => {
  await page.goto('./#example=fig-99-nothing');
  await expect(page.getByRole('alert')).toContainText('There is no example called fig-99-nothing');
  await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
});

test('points without faces are shown, counted and solved', async ({ page }) => {
  await page.goto('./#example=points-pavilion');
  const { faces, constraints } = await waitForState(page, (state) => state.vertices > 400);
  expect(faces).toBe(0);
  expect(constraints).toEqual({ line: 4, plane: 2, sphere: 1 });
  const before = known((await state(page)).energy).total;
  await page.getByRole('button', { name: 'Run' }).click();
  const { energy } = await waitForState(page, (state) => state.converged);
  expect(energy?.total).toBeLessThan(0.1 * before);
});
