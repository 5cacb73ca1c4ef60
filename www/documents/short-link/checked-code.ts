/** Bytes as base64url with a checksum, so that truncated or altered links are rejected. */

import { crc32 } from '../crc32.ts';

/** Digits of base64url; none of them needs escaping in a link. */
const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const SUM_BYTES = 4;

export function writeCode(bytes: Uint8Array) {
  const all = new Uint8Array(bytes.length + SUM_BYTES);
  all.set(bytes);
  new DataView(all.buffer).setUint32(bytes.length, crc32(bytes));
  let code = '';
  for (let at = 0; at < all.length; at += 3) {
    const three = (all[at] << 16) | ((all[at + 1] ?? 0) << 8) | (all[at + 2] ?? 0);
    const digits = Math.min(all.length - at, 3) + 1;
    for (let i = 0; i < digits; i++) code += DIGITS[(three >> (18 - 6 * i)) & 63];
  }
  return code;
}

/** Decodes the bytes; null if the code was truncated or altered. */
export function readCode(code: string) {
  const all = new Uint8Array(Math.floor((code.length * 3) / 4));
  let bits = 0;
  let held = 0;
  let at = 0;
  for (const letter of code) {
    const digit = DIGITS.indexOf(letter);
    if (digit < 0) return null;
    held = ((held << 6) | digit) & 0xffff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    all[at++] = held >> bits;
  }
  // The remaining bits must be 0 and fewer than a digit has.
  if (bits >= 6 || (held & ((1 << bits) - 1)) !== 0 || at < SUM_BYTES) return null;
  const bytes = all.subarray(0, at - SUM_BYTES);
  const sum = new DataView(all.buffer).getUint32(bytes.length);
  return sum === crc32(bytes) ? bytes : null;
}
