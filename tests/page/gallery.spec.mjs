// The gallery: every card leads to its example, and the filters find what they should.

import { expect, test, waitForState } from './support.mjs';

/** The entries of the list, as the page reads them. */
const listOf = async (page) => (await page.request.get('examples/index.json')).json();

async function openGallery(page) {
  await page.goto('./gallery.html');
  await expect(page.getByRole('article').first()).toBeVisible();
}

test('every example has a card with both pictures, and every picture is there', async ({
  page,
}) => {
  const examples = await listOf(page);
  await openGallery(page);
  await expect(page.getByRole('article')).toHaveCount(examples.length);
  for (const { title, summary, statement, kinds } of examples) {
    const card = page.getByRole('article', { name: title, exact: true });
    await expect(card).toContainText(summary);
    await expect(card).toContainText(statement.replaceAll(/\be_([cp])\b/g, 'e$1'));
    for (const words of ['at the start', kinds.length > 0 ? 'solved' : 'as a flat map']) {
      const picture = card.getByRole('img', { name: `${title}, ${words}` });
      await picture.scrollIntoViewIfNeeded();
      await expect
        .poll(() => picture.evaluate((image) => image.complete && image.naturalWidth))
        .toBeGreaterThan(100);
    }
  }
});

test('the start of every example differs visibly from its end', async ({ page }) => {
  await openGallery(page);
  // As pictures of 108 by 78 pixels: how much of them has another colour.
  const changed = await page.evaluate(async () => {
    const pixels = async (image) => {
      image.loading = 'eager';
      await image.decode();
      const canvas = new OffscreenCanvas(108, 78);
      const context = canvas.getContext('2d');
      context.fillStyle = '#888';
      context.fillRect(0, 0, 108, 78);
      context.drawImage(image, 0, 0, 108, 78);
      return context.getImageData(0, 0, 108, 78).data;
    };
    const parts = {};
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
  for (const [id, part] of Object.entries(changed)) {
    expect(part, `${id}: the part of its picture that changes`).toBeGreaterThan(0.01);
  }
});

test('words, figures and constraints find their examples', async ({ page }) => {
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
  await expect(page.getByRole('status')).toContainText('No example fits');
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

test('every card opens its example, one after another', async ({ page }, { project }) => {
  test.skip(project.name === 'phone', 'the same on a phone');
  test.setTimeout(600_000);
  const examples = await listOf(page);
  await openGallery(page);
  const addresses = [];
  for (const { title } of examples) {
    const link = page.getByRole('link', { name: title, exact: true });
    addresses.push(await link.getAttribute('href'));
  }
  expect(addresses).toEqual(examples.map(({ id }) => `./#example=${id}`));

  // The first from a cold start by its card, the others as the address of the page changes.
  await page.getByRole('link', { name: examples[4].title, exact: true }).click();
  await waitForState(page, (state, count) => state.vertices === count, examples[4].vertices);
  for (const [at, { title, id, vertices, faces, kinds }] of examples.entries()) {
    await page.evaluate((hash) => (location.hash = hash), `#example=${id}`);
    await expect(page.getByRole('status')).toHaveText(`Opened the example ${title}`);
    const {
      vertices: found,
      faces: panels,
      constraints,
    } = await waitForState(
      page,
      (state, given) => state.vertices === given[0] && state.faces === given[1],
      [vertices, faces],
    );
    expect([found, panels], id).toEqual([vertices, faces]);
    expect(Object.keys(constraints).sort(), id).toEqual(kinds.map((kind) => kind.id).sort());
    const beside = page.getByRole('navigation', { name: 'Examples one by one' });
    await expect(beside.getByRole('link', { name: 'Previous' })).toHaveCount(at > 0 ? 1 : 0);
    await expect(beside.getByRole('link', { name: 'Next' })).toHaveCount(
      at < examples.length - 1 ? 1 : 0,
    );
  }
});

test('a link opens its example from a cold start, and Next leads on', async ({ page }) => {
  const examples = await listOf(page);
  const at = examples.findIndex(({ id }) => id === 'fig-05-circular');
  await page.goto('./#example=fig-05-circular');
  await expect(page.getByRole('status')).toHaveText(`Opened the example ${examples[at].title}`);
  await waitForState(page, (state, count) => state.vertices === count, examples[at].vertices);
  expect(new URL(page.url()).hash).toBe('#example=fig-05-circular');
  const beside = page.getByRole('navigation', { name: 'Examples one by one' });
  if (!(await beside.isVisible())) await page.getByRole('tab', { name: 'Model' }).click();
  await beside.getByRole('link', { name: 'Next' }).click();
  await waitForState(page, (state, count) => state.vertices === count, examples[at + 1].vertices);
  await page.goBack();
  await waitForState(page, (state, count) => state.vertices === count, examples[at].vertices);
  // A model of one's own is no example.
  await page.evaluate(() =>
    window.shapeUp.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'triangle.obj'),
  );
  await expect(beside).toBeHidden();
});

test('a link to an example that does not exist says so and opens the first', async ({ page }) => {
  await page.goto('./#example=fig-99-nothing');
  await expect(page.getByRole('alert')).toContainText('There is no example called fig-99-nothing');
  await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
});

test('points without faces are seen, counted and solved', async ({ page }) => {
  await page.goto('./#example=points-pavilion');
  const { faces, constraints } = await waitForState(page, (state) => state.vertices > 400);
  expect(faces).toBe(0);
  expect(constraints).toEqual({ line: 4, plane: 2, sphere: 1 });
  const before = (await page.evaluate(() => window.shapeUp.state())).energy.total;
  await page.getByRole('button', { name: 'Run' }).click();
  const { energy } = await waitForState(page, (state) => state.converged);
  expect(energy.total).toBeLessThan(0.1 * before);
});
