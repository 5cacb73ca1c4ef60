// One story, from a file to a reload, in any browser that can be driven.

import assert from 'node:assert/strict';
import { setTimeout as wait } from 'node:timers/promises';

/**
 * @typedef {object} Browser
 * @property {(url: string) => Promise<unknown>} open
 * @property {(text: string, ...args: unknown[]) => Promise<any>} ask calls a function, given as text,
 *   in the page
 * @property {(selector: string, path: string) => Promise<unknown>} choose a file in a file input
 * @property {(way: import('./pointer.mjs').Place[], keys?: string[]) => Promise<unknown>} pointer
 */

/** Drawing in software, and a compiler that warms up. */
const PATIENCE_MS = 120_000;

/**
 * Opens a mesh, makes its panels circular, drags a vertex, exports, and reloads.
 * @param {Browser} browser
 * @param {string} address of the page
 * @param {{ path: string, vertices: number, held: number }} mesh a file, its number of vertices, and
 *   the vertex to drag
 * @returns what draws the view, and the positions of the circular shape
 */
export async function tell(browser, address, { path, vertices, held }) {
  const state = () => browser.ask('() => window.shapeUp.state()');
  const shape = () => browser.ask('() => [...window.shapeUp.positions()]');
  const until = async (what, condition, ...args) => {
    for (const start = performance.now(); ; await wait(200)) {
      const found = await browser.ask(condition, ...args);
      if (found) return found;
      assert.ok(performance.now() < start + PATIENCE_MS, `expected: ${what}`);
    }
  };
  const press = async (name) => {
    await browser.pointer([await until(`a button ${name} that stands still`, placeOfButton, name)]);
  };
  const isDrawn = "() => window.shapeUp?.state().renderer.startsWith('web')";

  await browser.open(address);
  await until('the first model is drawn', isDrawn);

  await browser.choose('input[type=file]', path);
  await until('the mesh is open', '(n) => window.shapeUp.state().vertices === n', vertices);

  await press('Make panels circular');
  const ended = '() => !window.shapeUp.state().running && window.shapeUp.state().verdict !== null';
  await until('a verdict', ended);
  const { verdict, renderer } = await state();
  assert.equal(verdict.within, verdict.of, 'all panels are circular');
  const circular = await shape();

  const [x, y] = await until('a vertex that stands still', placeOfVertex, held);
  const way = [0, 10, 25, 40].map((up) => [x, y - up]);
  await browser.pointer(way, ['Alt']);
  await until('a handle', '() => window.shapeUp.state().handles.length === 1');
  const dragged = await until('the shape is at rest', shapeAtRest);
  const moved = Math.hypot(...[0, 1, 2].map((i) => dragged[3 * held + i] - circular[3 * held + i]));
  assert.ok(moved > 0.1, `the dragged vertex has moved by ${moved}`);

  await browser.ask(keepFiles);
  await press('Export');
  await until('a file', '() => window.saved.length === 1');
  const text = await browser.ask('() => window.saved[0].text()');
  assert.deepEqual(positionsOf(text), dragged, 'the file has the shape of the view');

  await browser.ask('() => window.shapeUp.settled()');
  await browser.open(address);
  await until('the work is back', '(n) => window.shapeUp?.state().vertices === n', vertices);
  await until('it is drawn', isDrawn);
  assert.equal((await state()).handles.length, 1);
  assert.deepEqual(await shape(), dragged);

  return { renderer, circular };
}

/** The coordinates in an OBJ file. */
export const positionsOf = (text) =>
  [...text.matchAll(/^v (\S+) (\S+) (\S+)$/gm)].flatMap((line) => line.slice(1, 4).map(Number));

/**
 * In the page: the middle of the button of this name, scrolled into view; nothing while it moves or
 * something lies over it.
 */
const placeOfButton = `async (name) => {
  const isIt = (one) => (one.ariaLabel || one.textContent).trim() === name && one.checkVisibility();
  const button = [...document.querySelectorAll('button')].findLast(isIt);
  if (!button) return null;
  button.scrollIntoView({ block: 'center' });
  const middle = () => {
    const { left, top, width, height } = button.getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  };
  const before = middle();
  await new Promise((done) => setTimeout(done, 300));
  const now = middle();
  const stands = String(now) === String(before);
  return stands && button.contains(document.elementFromPoint(...now)) ? now : null;
}`;

/** In the page: where a vertex is drawn; nothing while that changes. */
const placeOfVertex = `async (vertex) => {
  const before = window.shapeUp.screen(vertex);
  await new Promise((done) => setTimeout(done, 1000));
  await window.shapeUp.drawn();
  const now = window.shapeUp.screen(vertex);
  return String(now) === String(before) ? now : null;
}`;

/** In the page: the current positions; nothing while they change. */
const shapeAtRest = `async () => {
  const before = window.shapeUp.positions();
  await new Promise((done) => setTimeout(done, 1000));
  await window.shapeUp.settled();
  const now = window.shapeUp.positions();
  return String(now) === String(before) ? [...now] : null;
}`;

/** In the page: what is saved from now on is kept in \`saved\`. */
const keepFiles = `() => {
  window.saved = [];
  const made = URL.createObjectURL.bind(URL);
  URL.createObjectURL = (blob) => {
    if (blob instanceof Blob) window.saved.push(blob);
    return made(blob);
  };
}`;
