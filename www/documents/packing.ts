/** Packing of bytes for links: DEFLATE with a limit on the unpacked size, and a checksum. */

/** Largest size in bytes to which data may unpack. */
export const MOST_BYTES = 32 << 20;
/** Bytes passed to the decompressor at once: each can expand to about a thousand. */
const PIECE = 768;
/** Unpacked bytes after which the page's event loop gets a turn. */
const TURN = 1 << 20;
const FORMAT = 'deflate-raw';

/** Compresses. */
export async function deflate(content: Blob) {
  const packed = content.stream().pipeThrough(new CompressionStream(FORMAT));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

/**
 * Decompresses piece by piece; rejects what was not compressed.
 * @returns null if it has more than `MOST_BYTES`
 */
export async function inflate(bytes: Uint8Array): Promise<Uint8Array<ArrayBuffer> | null> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  let turn = TURN;
  const reader = inPieces(bytes).pipeThrough(new DecompressionStream(FORMAT)).getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    size += value.length;
    // The stream unpacks no more than is read, so that stopping here bounds the memory.
    if (size > MOST_BYTES) return null;
    parts.push(value);
    if (size < turn) continue;
    turn = size + TURN;
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Returns a stream of bytes that supplies a piece on each request. */
function inPieces(bytes: Uint8Array): ReadableStream<Uint8Array<ArrayBuffer>> {
  let from = 0;
  const source = {
    pull(controller: ReadableStreamDefaultController) {
      if (from >= bytes.length) return controller.close();
      controller.enqueue(bytes.slice(from, (from += PIECE)));
    },
  };
  return new ReadableStream(source, { highWaterMark: 0 });
}

/** The remainder of each byte in the checksum. */
const REMAINDERS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let left = byte;
  for (let bit = 0; bit < 8; bit++) left = left & 1 ? 0xedb88320 ^ (left >>> 1) : left >>> 1;
  return left;
});

/** The CRC-32 of IEEE 802.3, which detects burst errors up to 32 bits. */
export function crc32(bytes: Uint8Array) {
  let left = -1;
  for (const byte of bytes) left = REMAINDERS[(left ^ byte) & 255] ^ (left >>> 8);
  return ~left >>> 0;
}
