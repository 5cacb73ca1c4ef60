/** The unit and the vertical axis of files that have none, remembered by their contents. */

import { getItem, setItem } from '../ui/safe-storage.ts';

export type Frame = { units: string; up: 'y' | 'z' };

const KEY = 'shape-up.frames';
/** Number of files remembered. */
const MOST_FILES = 40;

/** A file and its frame, and which parts of that are only a guess. */
type Known = [digest: string, frame: Frame, guessed?: Record<keyof Frame, boolean>];

/** Other code may have written to the key. */
const isKnown = (one: unknown) =>
  Array.isArray(one) && /^[yz]$/.test(one[1]?.up) && typeof one[1].units === 'string';

/** @returns newest last */
function remembered(): Known[] {
  try {
    const all: unknown = JSON.parse(getItem(KEY) ?? '[]');
    return Array.isArray(all) ? all.filter(isKnown) : [];
  } catch {
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
  const [, frame, guessed] = remembered().find(([known]) => known === digest) ?? [];
  const parts = (['units', 'up'] as const).filter((part) => !guessed?.[part]);
  return frame ? parts.map((part) => `# ${part}: ${frame[part]}\n`).join('') : '';
}

/** Remembers what is no guess, if anything, in place of what was remembered of the file. */
export function rememberFrame(...known: Required<Known>) {
  const [digest, , guessed] = known;
  const others = remembered().filter(([other]) => other !== digest);
  const isGuess = guessed.units && guessed.up;
  setItem(KEY, JSON.stringify([...others, ...(isGuess ? [] : [known])].slice(-MOST_FILES)));
}
