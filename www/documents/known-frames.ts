/** The unit and the vertical axis of files that have none, remembered by their contents. */

import { getItem, setItem } from '../ui/safe-storage.ts';

export type Frame = { units: string; up: 'y' | 'z' };

const KEY = 'shape-up.frames';
/** Number of files remembered. */
const MOST_FILES = 40;

/** Other code may have written to the key. */
const isKnown = (one: unknown) =>
  Array.isArray(one) && /^[yz]$/.test(one[1]?.up) && typeof one[1].units === 'string';

/** @returns newest last */
function remembered(): [string, Frame][] {
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
  const frame = remembered().find(([known]) => known === digest)?.[1];
  return frame ? `# units: ${frame.units}\n# up: ${frame.up}\n` : '';
}

/**
 * @param digest of a file
 * @param frame null to forget what is remembered
 */
export function rememberFrame(digest: string, frame: Frame | null) {
  const others = remembered().filter(([known]) => known !== digest);
  const all = [...others, ...(frame ? [[digest, frame]] : [])].slice(-MOST_FILES);
  setItem(KEY, JSON.stringify(all));
}
