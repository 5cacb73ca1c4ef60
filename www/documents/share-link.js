/**
 * Links that carry a scene. All of it is in the fragment, which never leaves the browser:
 *
 * | fragment | is |
 * |---|---|
 * | `#example=ID` | an example as it comes |
 * | `#example=ID&edits=CODE` | its mesh with another scene: what was edited |
 * | `#scene=CODE` | a scene with its mesh |
 *
 * `&run` iterates after opening. CODE is the text of a scene without its current positions, deflated,
 * in base64url: what was solved is solved again, so that no rounded result stands beside its errors. A design that
 * was kept is in the scene: it is where the scene starts.
 */

/** @typedef {import("./files.js").Example} Example */

/** A scene that unpacks to more than this is not a scene that somebody made here, in bytes. */
export const MOST_BYTES = 32 << 20;
/** So many characters are unpacked at once, a multiple of four: each byte in them can become a thousand. */
const PIECE = 1 << 10;
/** After so many unpacked bytes the page has a turn. */
const TURN = 1 << 20;
const FORMAT = 'deflate-raw';

/**
 * What a fragment says.
 * @typedef {object} Link
 * @property {string | null} example id
 * @property {string | null} code of the scene, or of the edits of the example
 * @property {boolean} run
 */

/**
 * @param {string} hash of an address, with its #
 * @returns {Link | null} null when it is not a link of this page
 */
export function readLink(hash) {
  const parts = new URLSearchParams(hash.slice(1));
  const example = parts.get('example');
  const code = parts.get('scene') ?? parts.get('edits');
  if (!example && !code) return null;
  return { example, code, run: parts.has('run') };
}

/**
 * The address that opens the scene as it is now.
 * @param {Pick<import("../app/context.js").AppContext, "store" | "actions" | "files">} app
 */
export async function linkTo({ store, actions, files }) {
  const text = await actions.sceneText();
  const { numbers } = store.get();
  const { example } = files.origin;
  const { variants, current } = JSON.parse(text);
  // A design that was kept is as exact as it was.
  const isKept = variants?.design !== undefined && !current;
  const run = (numbers?.iteration ?? 0) > 0 && !isKept;
  const fragment = await writeLink(text, example, files.original, run);
  return new URL(fragment, location.href.split('#')[0]).href;
}

/**
 * The fragment of a link to a scene.
 * @param {string} text of the scene with its mesh
 * @param {Example | undefined} example whose mesh it has
 * @param {string | null} original text of the scene as the example came
 * @param {boolean} run
 */
export async function writeLink(text, example, original, run) {
  const scene = withoutPositions(text);
  const end = run ? '&run' : '';
  if (!example) return `#scene=${await pack(JSON.stringify(scene))}${end}`;
  const edits = { ...scene, mesh: { file: example.mesh } };
  const before = original && { ...withoutPositions(original), mesh: { file: example.mesh } };
  const start = `#example=${encodeURIComponent(example.id)}`;
  if (before && JSON.stringify(before) === JSON.stringify(edits)) return start + end;
  return `${start}&edits=${await pack(JSON.stringify(edits))}${end}`;
}

/** @param {string} text of a scene */
function withoutPositions(text) {
  const scene = JSON.parse(text);
  delete scene.current;
  return scene;
}

/** @param {string} text */
async function pack(text) {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream(FORMAT));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  let binary = '';
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/**
 * The text that was packed. It is unpacked piece by piece, and no further than a scene can be.
 * @param {string} code
 */
export async function unpack(code) {
  const decoder = new TextDecoder();
  let text = '';
  let size = 0;
  let turn = TURN;
  try {
    const reader = inPieces(code).pipeThrough(new DecompressionStream(FORMAT)).getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return text + decoder.decode();
      size += value.length;
      // Nothing more is unpacked than is read.
      if (size > MOST_BYTES) break;
      text += decoder.decode(value, { stream: true });
      if (size < turn) continue;
      turn = size + TURN;
      await new Promise((resolve) => setTimeout(resolve));
    }
  } catch {
    throw new Error(
      'The link is incomplete or damaged: it was probably cut when it was sent. Ask for it again, or for the scene as a file.',
    );
  }
  const most = MOST_BYTES >> 20;
  throw new Error(`The link unpacks to more than ${most} MB. Ask for the scene as a file.`);
}

/**
 * A stream of the bytes that are in base64url, each piece when it is asked for.
 * @param {string} code
 * @returns {ReadableStream<Uint8Array<ArrayBuffer>>}
 */
function inPieces(code) {
  let from = 0;
  const source = {
    pull(/** @type {ReadableStreamDefaultController} */ controller) {
      if (from >= code.length) return controller.close();
      const piece = code.slice(from, (from += PIECE));
      const binary = atob(piece.replaceAll('-', '+').replaceAll('_', '/'));
      controller.enqueue(Uint8Array.from(binary, (character) => character.charCodeAt(0)));
    },
  };
  return new ReadableStream(source, { highWaterMark: 0 });
}
