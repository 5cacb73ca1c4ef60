/**
 * The unit and the vertical axis of the model: chosen in the panel, asked for after a file that does
 * not say them, and remembered by the name of the file. Coordinates never change by it.
 */

import { element, icon } from './dom.js';
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
 */
function changes(store, actions) {
  /** @param {Partial<Frame>} part */
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
 * Asks after a file that does not say them, with what was guessed chosen already.
 * @param {HTMLElement} place
 * @param {Store} store
 * @param {Actions} actions
 * @param {import("./files.js").Files} files
 */
export function frameChips(place, store, actions, files) {
  const change = changes(store, actions);
  const close = () => place.replaceChildren();

  files.addEventListener('opened', () => {
    const { model } = store.get();
    close();
    if (model && (model.guessed.units || model.guessed.up)) place.append(strip(model.name));
  });
  store.subscribe(['document'], ({ document }) => {
    for (const chip of place.querySelectorAll('button[data-value]')) {
      if (!(chip instanceof HTMLElement) || !document) continue;
      const now = chip.dataset.part === 'up' ? document.up : document.units;
      chip.setAttribute('aria-pressed', String(chip.dataset.value === now));
    }
  });

  /** @param {string} name of the file */
  function strip(name) {
    return element(
      'div',
      { class: 'message notice frame-chips', role: 'group', 'aria-label': 'Unit and up axis' },
      element('p', {}, `${name} does not say these. Guessed:`),
      chips('Up', 'up', ['z', 'y']),
      chips('Unit', 'units', UNITS),
      element(
        'button',
        { type: 'button', class: 'small primary', onclick: () => accept() },
        'That is right',
      ),
      element(
        'button',
        { type: 'button', class: 'tiny', 'aria-label': 'Dismiss', onclick: close },
        icon('close'),
      ),
    );
  }

  async function accept() {
    // Nothing changes, but it will not be asked again.
    await change({});
    close();
  }

  /**
   * @param {string} label
   * @param {"up" | "units"} part
   * @param {string[]} values
   */
  function chips(label, part, values) {
    const now = store.get().document?.[part];
    return element(
      'div',
      { class: 'segmented', role: 'group', 'aria-label': label },
      element('span', { class: 'quiet', 'aria-hidden': 'true' }, label),
      ...values.map((value) =>
        element(
          'button',
          {
            type: 'button',
            'data-part': part,
            'data-value': value,
            'aria-pressed': String(value === now),
            onclick: () => change({ [part]: value }),
          },
          value || 'none',
        ),
      ),
    );
  }
}
