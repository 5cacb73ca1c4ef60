/** Compression by DEFLATE, with a limit on the unpacked size. */

/** Largest size in bytes to which a scene may unpack. */
export const MOST_BYTES = 32 << 20;
/** Bytes passed to the decompressor at once: each can expand to about a thousand. */
const PIECE = 768;
/** Unpacked bytes after which the page's event loop gets a turn. */
const TURN = 1 << 20;
const FORMAT = 'deflate-raw';

/** Returns the error for a truncated or altered link. */
export const damaged = () =>
  new Error(
    'The link is incomplete or damaged: it was probably truncated. Ask the sender for the link again, or for the scene file.',
  );

export async function deflate(content: string | Uint8Array<ArrayBuffer>) {
  const packed = new Blob([content]).stream().pipeThrough(new CompressionStream(FORMAT));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

/** Decompresses text, piece by piece. */
export async function inflate(bytes: Uint8Array) {
  const decoder = new TextDecoder();
  let text = '';
  let size = 0;
  let turn = TURN;
  try {
    const reader = inPieces(bytes).pipeThrough(new DecompressionStream(FORMAT)).getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return text + decoder.decode();
      size += value.length;
      // The stream unpacks no more than is read, so that stopping here bounds the memory.
      if (size > MOST_BYTES) break;
      text += decoder.decode(value, { stream: true });
      if (size < turn) continue;
      turn = size + TURN;
      await new Promise((resolve) => setTimeout(resolve));
    }
  } catch {
    throw damaged();
  }
  const most = MOST_BYTES >> 20;
  throw new Error(`The link unpacks to more than ${most} MB. Ask the sender for the scene file.`);
}

/** Decompresses the base64url text of a link of an earlier version. */
export async function inflated(code: string) {
  const binary = plain(code.replaceAll('-', '+').replaceAll('_', '/'));
  return inflate(Uint8Array.from(binary, (character) => character.charCodeAt(0)));
}

/** @param code in base64 */
function plain(code: string) {
  try {
    return atob(code);
  } catch {
    throw damaged();
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
