/**
 * The unit and the vertical axis of the model: chosen in the panel, asked for after a file that does
 * not say them, and remembered by the name of the file. Coordinates never change by it.
 */

import { element } from './dom.js';
import { recall, remember } from './stored.js';

/** @typedef {import("./state.js").Store} Store */
/** @typedef {import("./actions.js").Actions} Actions */
/** @typedef {{ units: string, up: "y" | "z" }} Frame */

/** With the empty one for a mesh without a unit. */
const UNITS = ['m', 'cm', 'mm', 'ft', 'in', ''];
const NO_UNIT = 'no unit';
const KEY = 'shape-up.frames';
/** So many files are remembered. */
const MOST_FILES = 40;

/** @returns {[string, Frame][]} the newest last */
function remembered() {
  try {
    return JSON.parse(recall(KEY) ?? '[]');
  } catch {
    // Somebody else wrote there.
    return [];
  }
}

/**
 * What the file of that name was taken for the last time, in the words of a mesh file.
 * @param {string} name
 */
export function rememberedFrame(name) {
  const frame = remembered().find(([known]) => known === name)?.[1];
  return frame ? `# units: ${frame.units}\n# up: ${frame.up}\n` : '';
}

/**
 * @param {string} name of a file
 * @param {Frame} frame
 */
function rememberFrame(name, frame) {
  const others = remembered().filter(([known]) => known !== name);
  const all = [...others, [name, frame]].slice(-MOST_FILES);
  remember(KEY, JSON.stringify(all));
}

/**
 * Changes them, as one step of undo each.
 * @param {Store} store
 * @param {Actions} actions
 * @returns {(part: Partial<Frame>) => Promise<void>}
 */
function changes(store, actions) {
  return async (part) => {
    const { model, document } = store.get();
    if (!model || !document) return;
    const { units = document.units, up = document.up } = part;
    if (units !== document.units) await actions.edit({ type: 'setUnits', units });
    if (up !== document.up) await actions.edit({ type: 'setUp', up });
    rememberFrame(model.name, { units, up });
  };
}

/**
 * Two rows of the panel of the model.
 * @param {Store} store
 * @param {Actions} actions
 * @returns {HTMLElement} always up to date
 */
export function frameFields(store, actions) {
  const change = changes(store, actions);
  const units = element('select', {
    id: 'units',
    onchange: () => change({ units: units.value }),
  });
  const up = element(
    'select',
    { id: 'up', onchange: () => change({ up: up.value === 'y' ? 'y' : 'z' }) },
    element('option', { value: 'z' }, 'z'),
    element('option', { value: 'y' }, 'y'),
  );
  store.subscribe(['document'], ({ document }) => {
    if (!document) return;
    const known = UNITS.includes(document.units) ? UNITS : [document.units, ...UNITS];
    const options = known.map((unit) => element('option', { value: unit }, unit || NO_UNIT));
    units.replaceChildren(...options);
    units.value = document.units;
    up.value = document.up;
  });
  const title = 'What the numbers of the file mean. They stay as they are.';
  return element(
    'div',
    { class: 'frame-fields', title },
    element('label', { for: 'units' }, 'Unit'),
    units,
    element('label', { for: 'up' }, 'Up axis'),
    up,
  );
}

/**
 * Asks after a file that does not say them. What asks comes with the first such file.
 * @param {HTMLElement} place
 * @param {Store} store
 * @param {Actions} actions
 * @param {import("./files.js").Files} files
 */
export function askForFrames(place, store, actions, files) {
  /** @type {Promise<import("./frame-question.js").FrameQuestion> | undefined} */
  let question;
  files.addEventListener('opened', async () => {
    place.replaceChildren();
    const { model } = store.get();
    if (!model?.guessed.units && !model?.guessed.up) return;
    question ??= import('./frame-question.js').then(
      ({ FrameQuestion }) => new FrameQuestion(place, store, UNITS, changes(store, actions)),
    );
    const asks = await actions.told(question);
    if (store.get().model === model) asks?.ask(model.name);
  });
}
