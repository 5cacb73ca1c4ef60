/**
 * The unit and the vertical axis of the model: fields of its panel that show whether they were
 * guessed and remember the choice by the contents of the file. The coordinates never change.
 */

import { element, removeKeepingFocus, setText } from '../ui/dom.ts';
import { getItem, setItem } from '../ui/safe-storage.ts';
import { UNITS } from '../ui/units.ts';
import type { AppContext } from '../app/context.ts';
import type { Store } from '../store/state.ts';
import type { Actions } from '../store/actions.ts';
import type { Loaded } from '../solver/types.ts';

type Frame = { units: string; up: 'y' | 'z' };

/** Units, and the empty string for a mesh without a unit. */
const SYMBOLS = [...UNITS.map(({ symbol }) => symbol), ''];
const NO_UNIT = 'no unit';
const KEY = 'shape-up.frames';
/** Number of files remembered. */
const MOST_FILES = 40;

/** @returns newest last */
function remembered(): [string, Frame][] {
  try {
    return JSON.parse(getItem(KEY) ?? '[]');
  } catch {
    // Other code has written to this key.
    return [];
  }
}

/**
 * Returns what tells the contents of a file from those of any other; null where the browser has no
 * hash function, as at an address without encryption: then nothing is remembered.
 */
export async function digestOf(bytes: BufferSource): Promise<string | null> {
  const hash = await crypto.subtle?.digest('SHA-256', bytes);
  return hash ? btoa(String.fromCharCode(...new Uint8Array(hash))) : null;
}

/**
 * Returns the remembered frame as comment lines of a mesh file.
 * @param digest of the file
 */
export function rememberedFrame(digest: string | null) {
  const frame = remembered().find(([known]) => known === digest)?.[1];
  return frame ? `# units: ${frame.units}\n# up: ${frame.up}\n` : '';
}

/** @param digest of a file */
function rememberFrame(digest: string, frame: Frame) {
  const others = remembered().filter(([known]) => known !== digest);
  const all = [...others, [digest, frame]].slice(-MOST_FILES);
  setItem(KEY, JSON.stringify(all));
}

/** Returns a function that changes unit and axis, each as one step of undo. */
function changes(
  store: Store,
  actions: Actions,
  files: { digest: string | null },
): (part: Partial<Frame>) => Promise<void> {
  return async (part) => {
    const { model, document } = store.get();
    if (!model || !document) return;
    const { units = document.units, up = document.up } = part;
    if (units !== document.units) await actions.edit({ setUnits: { units } });
    if (up !== document.up) await actions.edit({ setUp: { up } });
    if (files.digest) rememberFrame(files.digest, { units, up });
  };
}

/** Returns the rows of the model panel: the guess and the two fields, kept up to date. */
export function frameFields({
  store,
  actions,
  files,
}: Pick<AppContext, 'store' | 'actions' | 'files'>): HTMLElement {
  const apply = changes(store, actions, files);
  let confirmed: Loaded | null = null;
  const change = async (part: Partial<Frame>) => {
    await apply(part);
    confirmed = store.get().model;
    showGuess();
  };
  const units = element('select', { id: 'units', onchange: () => change({ units: units.value }) });
  const up = element(
    'select',
    { id: 'up', onchange: () => change({ up: up.value === 'y' ? 'y' : 'z' }) },
    element('option', { value: 'z' }, 'z'),
    element('option', { value: 'y' }, 'y'),
  );
  const guess = element('span');
  const note = element(
    'p.guess',
    { hidden: true },
    guess,
    element(
      'button.small.bordered',
      // Confirms the guess: nothing changes, but the file is remembered.
      { onclick: () => removeKeepingFocus(note, () => change({})) },
      'Yes',
    ),
  );
  function showGuess() {
    const { model } = store.get();
    const words = model && guessInWords(model);
    note.hidden = !words || model === confirmed;
    if (words) setText(guess, words);
  }
  store.subscribe(['model'], showGuess);
  store.subscribe(['document', 'refused'], ({ document }) => {
    if (!document) return;
    const known = SYMBOLS.includes(document.units) ? SYMBOLS : [document.units, ...SYMBOLS];
    const options = known.map((unit) => element('option', { value: unit }, unit || NO_UNIT));
    units.replaceChildren(...options);
    units.value = document.units;
    up.value = document.up;
  });
  const title = 'Unit and vertical axis of the coordinates. The coordinates do not change.';
  return element(
    'div.frame-fields',
    { title },
    note,
    element('label', { for: 'units' }, 'Unit'),
    units,
    element('label', { for: 'up' }, 'Up axis'),
    up,
  );
}

/**
 * Asks about the unit or axis that was guessed because the file has none; empty if nothing was.
 */
function guessInWords({ guessed }: Loaded) {
  if (guessed.units && guessed.up) return 'Unit and up axis are not in the file. Are these right?';
  if (guessed.units) return 'The unit is not in the file. Is this right?';
  return guessed.up ? 'The up axis is not in the file. Is this right?' : '';
}
