// In any state of the page axe finds no violations, in either theme, each value is shown once, and no
// text is hidden.

import type { Page, ViewportSize } from '@playwright/test';
import AxeBuilder from '@axe-core/playwright';
import { openText } from '../actions.ts';
import { faintTexts } from '../faint-texts.ts';
import { hiddenTexts } from '../hidden-texts.ts';
import { endlessScene, wavyGrid } from '../meshes.ts';
import { repeatedValues } from '../repeated-values.ts';
import { expect, LONG, openPage, state, test, visit, waitForState } from '../support.ts';
import { walks, withoutGraphics } from '../walks.ts';

/**
 * Returns axe's violations, one line each, and the texts of too little contrast among those that axe
 * leaves undecided: it does so with text in the very colour of its background, and with text that is
 * partly scrolled out of sight. None of these pages has its content in frames, so axe's legacy mode,
 * which opens no extra page, is enough.
 * @param rules all if absent
 */
async function complaintsOf(page: Page, rules?: string[]) {
  // A document that has axe already is not sent its half a megabyte again.
  const axeSource = (await page.evaluate(() => 'axe' in window)) ? ';' : undefined;
  const axe = new AxeBuilder({ page, axeSource })
    .setLegacyMode()
    .options({ resultTypes: ['violations', 'incomplete'] });
  const { violations, incomplete } = await (rules ? axe.withRules(rules) : axe).analyze();
  const found = violations.flatMap(({ id, impact, nodes }) =>
    nodes.map(({ target, failureSummary = '' }) => {
      const reason = failureSummary.split('\n').slice(1, 3).join(' ').trim();
      return `${impact} ${id} at ${target.join(' ')}: ${reason}`;
    }),
  );
  const undecided = incomplete.flatMap(({ id, nodes }) =>
    id === 'color-contrast' ? nodes.map(({ target }) => target.join(' ')) : [],
  );
  return [...found, ...(await faintTexts(page, undecided))];
}

/** Runs in the page: whether nothing fades any more. */
const isAtRest = () => !document.getAnimations().some((one) => one instanceof CSSTransition);

/** axe's colour rules, the only ones that depend on the theme. */
const OF_COLOURS = ['color-contrast', 'link-in-text-block'];

/** The windows of tablets, in both directions, to which a desktop's is changed in long tests. */
const TABLETS = [
  { width: 1024, height: 768 },
  { width: 820, height: 1180 },
];

/**
 * Checks both themes; on a phone only one if the test is not to be long, because its colours are the
 * same as in other windows.
 */
async function expectNothing(page: Page, name = '') {
  const isPhone = test.info().project.name === 'phone';
  const own = page.viewportSize() as ViewportSize;
  // The size of a full screen is fixed.
  const isFull = await page.evaluate(() => document.fullscreenElement !== null);
  const windows = LONG && !isPhone && !isFull ? [own, ...TABLETS] : [own];
  const isOpen = await openParts(page);
  for (const size of windows) {
    if (windows.length > 1) await page.setViewportSize(size);
    expect(await openParts(page), `${name} stays as it is in another window`).toEqual(isOpen);
    expect.soft(await repeatedValues(page), `${name}: each value once`).toEqual([]);
    expect.soft(await hiddenTexts(page), `${name}: each text in sight`).toEqual([]);
    await expectNothingInThemes(page, `${name}, ${size.width} by ${size.height}`, LONG || !isPhone);
  }
  if (windows.length > 1) await page.setViewportSize(own);
}

/** The ids of what is open beside the steps: dialogs, menus, docked panels. */
const openParts = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('dialog[open], :popover-open, .docked:not([hidden])')].map(
      ({ id }) => id,
    ),
  );

async function expectNothingInThemes(page: Page, name: string, inBoth: boolean) {
  const themes: ['light' | 'dark', string[] | undefined][] = [
    ['light', undefined],
    ['dark', OF_COLOURS],
  ];
  for (const [colorScheme, rules] of inBoth ? themes : themes.slice(0, 1)) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    await page.waitForFunction(isAtRest);
    expect.soft(await complaintsOf(page, rules), `${name}, ${colorScheme}`).toEqual([]);
  }
}

for (const [title, states] of Object.entries(walks)) {
  // Walks with desktop states only are not run on a phone.
  const tag = states.every(({ only }) => only === 'desktop') ? ['@desktop'] : [];
  test(`axe: ${title}`, { tag }, async ({ page }, { project }) => {
    const seen = states.filter(({ only = project.name }) => only === project.name);
    await visit(page);
    let hasFocus = false;
    // Once something had the focus, the keyboard would otherwise begin again at the top.
    const expectFocus = async (when: string) => {
      const before = hasFocus;
      const isKept = () => page.evaluate(() => document.activeElement !== document.body);
      const message = `the focus fell to the body: ${when}`;
      if (before) await expect.poll(isKept, { message, timeout: 2000 }).toBe(true);
      hasFocus = await isKept();
    };
    for (const { name, reach, leave } of seen) {
      await test.step(name, async () => {
        await reach?.(page);
        await expectFocus(name);
        await expectNothing(page, name);
        await leave?.(page);
        await expectFocus(`${name}, left`);
      });
    }
  });
}

test.describe('with essential controls only', () => {
  test.use({ opened: false });

  test('axe: the essentials, at each suggested next step', async ({ page }) => {
    await visit(page);
    await expectNothing(page, 'solved');
    await openText(page, 'roof.obj', wavyGrid(6), 49);
    await expectNothing(page, 'opened');
    await page.getByRole('button', { name: 'Make panels flat' }).click();
    await waitForState(page, (now) => now.converged && !now.running);
    await expect(page.getByRole('group', { name: 'Panels', exact: true })).toContainText('flat');
    await expectNothing(page, 'made flat');
  });
});

test('a value that is shown twice is found', async ({ page }) => {
  const texts = [
    'Worst 35.8 mm',
    'off by 35.8 mm',
    'Moved 213 mm',
    'up to 213 mm',
    '1 of 4',
    '5 mm',
  ];
  const line = (text: string) => `<p>${text}</p>`;
  const hidden = '<p hidden>Worst 4.25 mm</p><p>4.25 mm</p>';
  const html = `${texts.map(line).join('')}${line('1 of 4')}${line('5 mm')}${hidden}`;
  await page.goto('./licences.html');
  await page.evaluate((html) => (document.body.innerHTML = html), html);
  expect(await repeatedValues(page)).toEqual([
    '35.8 mm: Worst 35.8 mm | off by 35.8 mm',
    '213 mm: Moved 213 mm | up to 213 mm',
  ]);
});

test('a text in the colour of its background is found', async ({ page }) => {
  await page.goto('./licences.html');
  const html =
    '<main><h1>Heading</h1><button>Save</button><p>Read</p></main>' +
    '<div hidden><p>Never shown</p></div>';
  await page.evaluate((html) => {
    document.body.innerHTML = html;
    const button = document.querySelector('button');
    if (button) button.style.cssText = 'color: rgb(31 95 196); background: rgb(31 95 196)';
  }, html);
  expect(await complaintsOf(page, OF_COLOURS)).toEqual(['contrast of 1.00 at button: “Save”']);
});

test('a button whose sentence is in columns is found', async ({ page }) => {
  const sentence = 'within <span>24 mm</span>; moves by <span>30 mm</span>';
  const button = (content: string) => `<button>${content}</button>`;
  await page.goto('./licences.html');
  const html = `${button(sentence)}${button(`<svg></svg>\n <span>${sentence}</span>`)}`;
  await page.evaluate((html) => {
    document.body.innerHTML = html;
    for (const button of document.querySelectorAll('button')) button.style.display = 'flex';
  }, html);
  expect(await hiddenTexts(page)).toEqual(['“within 24 mm; moves by 30 mm” is in 2 columns']);
});

test('axe: while only the HTML has loaded', async ({ page }) => {
  await page.route('**/{engine,view}-*.wasm', () => {});
  await page.goto('./');
  await expectNothing(page);
});

// With graphics, software rendering leaves axe no time while the solver runs.
test('axe: without graphics, and while running', async ({ page }) => {
  await withoutGraphics(page);
  await openPage(page);
  await expect(page.getByText('No 3D view')).toBeVisible();
  await expectNothing(page, 'without graphics');
  await openText(page, 'endless.shapeup.json', endlessScene(), 41 * 41);
  await page.getByRole('button', { name: 'Run' }).click();
  await waitForState(page, (now) => now.running && now.iteration > 0);
  await expectNothing(page, 'running');
  expect((await state(page)).running).toBe(true);
});

test('axe: the gallery, with and without results', async ({ page }) => {
  await page.goto('./gallery.html');
  const cards = page.getByRole('article');
  await expect(cards.first()).toBeVisible();
  await expectNothing(page, 'the gallery');
  await page.getByRole('searchbox', { name: 'Search' }).fill('no such thing');
  await expect(cards).toHaveCount(0);
  await expectNothing(page, 'with nothing found');
});

for (const [name, heading] of [
  ['checked', 'What is checked'],
  ['speed', 'How fast it is'],
  ['rhino', 'From Rhino and Grasshopper'],
  ['teaching', 'For teachers'],
  ['licences', 'Licences'],
]) {
  test(`axe: the page “${heading}”`, async ({ page }) => {
    await page.goto(`./${name}.html`);
    await expect(page.getByRole('heading', { name: heading, level: 1 })).toBeVisible();
    await expectNothing(page);
  });
}

test('axe: an embedded view that is not yet started', async ({ page }) => {
  await page.goto('./embed.html?embed#example=fig-05-circular');
  await expect(page.getByRole('img', { name: 'Hall of circular panels' })).toBeVisible();
  await expectNothing(page);
});

test('axe: a view that plays in another page', async ({ page }) => {
  await page.goto('./?embed&autoplay#example=hypar');
  await page.waitForFunction(() => window.shapeUp?.state().converged);
  await expectNothing(page);
});
