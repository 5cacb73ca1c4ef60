/** CRC-32 of IEEE 802.3, which detects burst errors up to 32 bits. */

/** The remainder of each byte. */
const REMAINDERS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let left = byte;
  for (let bit = 0; bit < 8; bit++) left = left & 1 ? 0xedb88320 ^ (left >>> 1) : left >>> 1;
  return left;
});

export function crc32(bytes: Uint8Array) {
  let left = -1;
  for (const byte of bytes) left = REMAINDERS[(left ^ byte) & 255] ^ (left >>> 8);
  return ~left >>> 0;
}
