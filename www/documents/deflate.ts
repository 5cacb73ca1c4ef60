/** Compression by DEFLATE, with a limit on the unpacked size. */

/** Largest size in bytes to which data may unpack. */
export const MOST_BYTES = 32 << 20;
/** Bytes passed to the decompressor at once: each can expand to about a thousand. */
const PIECE = 768;
/** Unpacked bytes after which the page's event loop gets a turn. */
const TURN = 1 << 20;
const FORMAT = 'deflate-raw';

export async function deflate(content: string | Uint8Array<ArrayBuffer> | Blob) {
  const packed = new Blob([content]).stream().pipeThrough(new CompressionStream(FORMAT));
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
