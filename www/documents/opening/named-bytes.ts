/** Reading of a chosen file. */

import type { NamedBytes } from '../../solver/types.ts';

/** @param name in place of its own */
export async function namedBytes(file: File, name: string = file.name): Promise<NamedBytes> {
  return { name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
