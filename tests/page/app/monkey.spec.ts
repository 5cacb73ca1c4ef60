// Random use: clicks, keys, drags, numbers and undo. The solver's worker must survive, nothing may
// throw, and undo must restore exactly the shape that was opened. It takes one round, with LONG=1 as
// many as SHAPE_UP_MONKEY_MINUTES allow (default 5). SHAPE_UP_MONKEY_SEED is the seed of the first
// round (default 1). A failing round reports its seed; setting it as the first seed repeats the round.

import type { Page } from '@playwright/test';
import { box, quadScene, tetScene, triangleScene, wavyGrid } from '../meshes.ts';
import { expect, LONG, openPage, test, windowOf } from '../support.ts';

const MINUTES = LONG ? Number(process.env.SHAPE_UP_MONKEY_MINUTES ?? 5) : 0;
const SEED = Number(process.env.SHAPE_UP_MONKEY_SEED ?? 1);
const DEEDS = 40;
const MESHES = [quadScene(3), triangleScene(4), tetScene(), box(), wavyGrid(6)];
const EXAMPLES = ['canopy', 'fig-04-squares', 'hypar', 'fig-08-similar-1', 'lesson-glass-roof'];
const SIZES = [
  [1440, 900],
  [1000, 700],
  [390, 844],
];
const KEYS = [
  ...[
    'v',
    'b',
    'l',
    'p',
    '1',
    '2',
    '3',
    '5',
    'f',
    'h',
    'm',
    'w',
    'o',
    'n',
    'i',
    'j',
    'c',
    'r',
    'x',
  ],
  ...[
    'Space',
    '.',
    '+',
    '-',
    '?',
    'Home',
    'Delete',
    'Escape',
    'Enter',
    'Tab',
    'PageUp',
    'PageDown',
  ],
  ...['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Shift+R', 'Shift+H', 'Shift+Tab'],
  ...['Control+a', 'Control+i', 'Control+z', 'Control+y', 'Control+k', 'Control+s', 'Control+e'],
];
const NUMBERS = [
  '0',
  '1',
  '2.5',
  '-3',
  '1e9',
  '1e-12',
  '1e308',
  'NaN',
  'Infinity',
  '',
  'roof',
  '50%',
];

/** Returns a number in [0, limit). */
type Draw = (limit: number) => number;

/** What undo must restore. */
interface Everything {
  scene: string;
  positions: number[];
  iteration: number;
}

declare global {
  interface Window {
    /** What was thrown in the page. */
    thrown: string[];
    /** The part around the target of an event that would leave the model, if there is one. */
    leadsOut(target: EventTarget | null): Element | null | undefined;
    everything(): Everything;
    /** The model as it was opened. */
    start?: Everything;
  }
}

/** Returns a generator of numbers in [0, limit), the same on every machine for a seed. */
function seeded(seed: number): Draw {
  let now = Math.imul(seed + 1, 2654435761) >>> 0;
  return (limit) => {
    now = (Math.imul(now, 1664525) + 1013904223) >>> 0;
    return Math.floor((now / 2 ** 32) * limit);
  };
}

/**
 * Runs in the page, before its scripts: blocks presses that would leave the model, records errors.
 */
function watch() {
  window.thrown = [];
  addEventListener('error', ({ message }) => message && window.thrown.push(message), true);
  addEventListener('unhandledrejection', ({ reason }) =>
    window.thrown.push(String(reason?.stack ?? reason)),
  );
  window.leadsOut = (target) =>
    (target as Partial<Element> | null)?.closest?.(
      'a, label:has([type=file]), [type=file], #examples, #recent, #alert, #hint-card',
    );
  addEventListener(
    'click',
    (event) => {
      if (!event.isTrusted || !window.leadsOut(event.target)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    true,
  );
}

/** Something to press: not everything can be disabled, or has labels. */
type Control = HTMLElement & Partial<Pick<HTMLInputElement, 'disabled' | 'labels'>>;

/** Runs in the page: the centre of the control with this number, if it can be pressed. */
function controlAt(number: number) {
  const controls = 'button, input, select, summary, [role=tab], [role=separator], [role=menuitem]';
  const all = [...document.querySelectorAll<Control>(controls)].flatMap((control) => {
    const { left, top, width, height } = control.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    const isThere = width > 0 && control.contains(document.elementFromPoint(x, y));
    return isThere && !control.disabled && !window.leadsOut(control) ? [{ control, x, y }] : [];
  });
  if (all.length === 0) return null;
  const { control, x, y } = all[number % all.length];
  if (control.localName === 'select') {
    const options = [...(control as HTMLSelectElement).options].filter(
      (option) => !option.disabled && !option.hidden,
    );
    const chosen = options[number % options.length];
    if (!chosen || chosen.selected) return null;
    chosen.selected = true;
    control.dispatchEvent(new Event('input', { bubbles: true }));
    control.dispatchEvent(new Event('change', { bubbles: true }));
    return { name: control.ariaLabel ?? control.id, x: 0, y: 0, isDone: true };
  }
  const name =
    control.ariaLabel || control.innerText || control.labels?.[0]?.innerText || control.id;
  return { name, x, y, isNumber: control.matches('[type=text]') };
}

/** A position in the window, often that of a vertex or a handle. */
async function place(page: Page, draw: Draw) {
  const { width, height } = windowOf(page);
  const anywhere: [number, number] = [draw(width), draw(height)];
  if (draw(3) === 0) return anywhere;
  const found = await page.evaluate((number) => {
    const { vertices, handles } = window.shapeUp.state();
    const isHandle = handles.length > 0 && number % 2;
    const vertex = isHandle ? handles[number % handles.length].vertex : number % (vertices || 1);
    return window.shapeUp.screen(vertex);
  }, draw(100_000));
  return found ?? anywhere;
}

/** A random action; returns a description. */
type Doing = (page: Page, draw: Draw) => Promise<string>;

const DOINGS: Doing[] = [
  async function click(page, draw) {
    const at = await place(page, draw);
    const options: { button: 'left' | 'right'; clickCount: number } = {
      button: draw(6) ? 'left' : 'right',
      clickCount: draw(5) ? 1 : 2,
    };
    await page.mouse.click(...at, options);
    return `${options.button} ${options.clickCount} ${at.map(Math.round)}`;
  },
  async function press(page, draw) {
    const control = await page.evaluate(controlAt, draw(100_000));
    if (!control) return 'nothing';
    if (!control.isDone) await page.mouse.click(control.x, control.y);
    if (control.isNumber) {
      const text = NUMBERS[draw(NUMBERS.length)];
      await page.keyboard.press('Control+a');
      await page.keyboard.type(text);
      await page.keyboard.press(draw(4) ? 'Enter' : 'Escape');
      return `${control.name}: ${text}`;
    }
    return control.name;
  },
  async function key(page, draw) {
    const name = KEYS[draw(KEYS.length)];
    if (draw(2)) await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press(name);
    return name;
  },
  async function drag(page, draw) {
    const from = await place(page, draw);
    const to = from.map((value) => value + draw(300) - 150) as [number, number];
    const held = [null, null, 'Shift', 'Control', 'Alt'][draw(5)];
    if (held) await page.keyboard.down(held);
    await page.mouse.move(...from);
    const button = draw(5) ? 'left' : 'right';
    await page.mouse.down({ button });
    await page.mouse.move(...to, { steps: 1 + draw(6) });
    const during = draw(5) ? null : ['Escape', 'Control+z', 'Space', 'h', 'x'][draw(5)];
    if (during) await page.keyboard.press(during);
    await page.mouse.up({ button });
    if (held) await page.keyboard.up(held);
    return `${button} ${from.map(Math.round)} to ${to.map(Math.round)} ${held ?? ''} ${during ?? ''}`;
  },
  async function pull(page, draw) {
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('v');
    const from = await place(page, draw);
    await page.mouse.move(...from);
    await page.keyboard.down('Alt');
    await page.mouse.down();
    await page.mouse.move(from[0] + draw(80) - 40, from[1] + draw(80) - 40, { steps: 3 });
    await page.mouse.up();
    await page.keyboard.up('Alt');
    return String(from.map(Math.round));
  },
  async function wheel(page, draw) {
    await page.mouse.wheel(0, draw(400) - 200);
    return '';
  },
  async function undo(page, draw) {
    const times = 1 + draw(4);
    for (let i = 0; i < times; i++) await page.keyboard.press(draw(3) ? 'Control+z' : 'Control+y');
    return String(times);
  },
  async function run(page) {
    await page.evaluate(() => (document.getElementById('run') as HTMLElement).click());
    return '';
  },
  async function resize(page, draw) {
    const [width, height] = SIZES[draw(SIZES.length)];
    await page.setViewportSize({ width, height });
    return `${width} by ${height}`;
  },
];
/** Relative frequency of each action. */
const OFTEN: Record<string, number> = {
  ...{ click: 2, press: 5, key: 3, drag: 3, pull: 2 },
  ...{ wheel: 1, undo: 1, run: 1, resize: 1 },
};
const ALL = DOINGS.flatMap((doing) => new Array<Doing>(OFTEN[doing.name]).fill(doing));

/** Opens a model and records its state, to which undo must return. */
async function open(page: Page, draw: Draw) {
  const which = draw(MESHES.length + EXAMPLES.length);
  const example = EXAMPLES[which - MESHES.length];
  await page.evaluate(
    async ([text, id]) => {
      const { shapeUp } = window;
      if (text) await shapeUp.open(text, text.startsWith('{') ? 'a.shapeup.json' : 'a.obj');
      else {
        const status = document.getElementById('status') as HTMLElement;
        const opened = new Promise<void>((done) => {
          const look = () => status.textContent.startsWith('Opened the example') && done();
          new MutationObserver(look).observe(status, { childList: true, subtree: true });
          new MutationObserver(look).observe(status, { characterData: true, subtree: true });
          // The same message may not be announced twice.
          setTimeout(done, 3000);
        });
        history.replaceState(null, '', location.pathname);
        location.hash = `example=${id}`;
        await opened;
      }
      await shapeUp.drawn();
      window.everything = () => ({
        scene: JSON.stringify(shapeUp.scene()),
        positions: [...shapeUp.positions()],
        iteration: shapeUp.state().iteration,
      });
      window.start = window.everything();
    },
    [MESHES[which], example],
  );
  return example ?? `mesh ${which}`;
}

/** Runs in the page: cancels gestures and undoes everything; returns the number of steps. */
async function undoAll() {
  const { shapeUp } = window;
  document.querySelectorAll<HTMLDialogElement>('dialog[open]').forEach((dialog) => dialog.close());
  (document.activeElement as HTMLElement | null)?.blur();
  // A run requested last may not have been reported yet.
  await shapeUp.settled();
  if (shapeUp.state().running) (document.getElementById('run') as HTMLElement).click();
  await shapeUp.settled();
  const undo = document.querySelector('[data-command="undo"]') as HTMLButtonElement;
  let done = 0;
  while (!undo.disabled && done < 2000) {
    undo.click();
    await shapeUp.drawn();
    done += 1;
  }
  return done;
}

/** Runs in the page: how the model differs from the one opened; empty if it does not. */
function difference() {
  const { start } = window;
  if (!start) return 'the page is another one';
  const now = window.everything();
  const at = start.positions.findIndex((x, i) => !Object.is(x, now.positions[i]));
  if (now.positions.length !== start.positions.length) return 'there is another model';
  if (at >= 0) return `position ${at}: ${start.positions[at]} became ${now.positions[at]}`;
  if (now.iteration !== start.iteration) return `iteration ${now.iteration}`;
  if (now.scene === start.scene) return '';
  const [a, b] = [start, now].map(({ scene }) => JSON.parse(scene));
  const keys = [...new Set([...Object.keys(a), ...Object.keys(b)])];
  const changed = keys.filter((key) => JSON.stringify(a[key]) !== JSON.stringify(b[key]));
  return changed.map((key) => `${key}: ${JSON.stringify(a[key])} became ${JSON.stringify(b[key])}`);
}

test.use({ fresh: true });

test('after random input the solver is alive and undo leads back to the start', async ({
  page,
}) => {
  test.setTimeout(MINUTES * 60_000 + 120_000);
  const workers = [];
  page.on('worker', (worker) => {
    if (worker.url().includes('solver-worker')) workers.push(worker);
  });
  page.on('filechooser', () => {});
  page.on('download', (download) => download.cancel().catch(() => {}));
  page.on('dialog', (dialog) => dialog.dismiss());
  page.context().on('page', (other) => other.close());
  await page.addInitScript(watch);
  await openPage(page);

  const until = Date.now() + MINUTES * 60_000;
  let [rounds, deeds, undone] = [0, 0, 0];
  for (let seed = SEED; rounds === 0 || Date.now() < until; seed++) {
    const draw = seeded(seed);
    const log = [`opened ${await open(page, draw)}`];
    const told = () => `seed ${seed}: ${log.join('; ')}`;
    for (let i = 0; i < DEEDS; i++) {
      const doing = ALL[draw(ALL.length)];
      log.push(`${doing.name} ${await doing(page, draw)}`);
      expect(await page.evaluate(() => window.thrown), told()).toEqual([]);
      expect(workers.length, `the worker was restarted; ${told()}`).toBe(1);
    }
    for (let i = 0; i < 3; i++) await page.keyboard.press('Escape');
    undone += await page.evaluate(undoAll);
    await expect
      .poll(() => page.evaluate(difference), { message: told(), timeout: 10_000 })
      .toBe('');
    rounds += 1;
    deeds += DEEDS;
  }
  expect(undone).toBeGreaterThan(0);
  process.stdout.write(`    ${rounds} rounds, ${deeds} deeds, ${undone} steps undone\n`);
});
