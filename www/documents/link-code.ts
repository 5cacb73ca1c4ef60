/**
 * Code of a link: base64url of a version (1 byte), the deflated content and a checksum (4 bytes).
 * The content is a line of JSON, and the numbers of the mesh if it is rounded, see `roundedMesh`.
 *
 * If the unrounded scene gives a code short enough to pass everywhere, that code is used. Otherwise
 * the positions of the mesh and of its handles are rounded to at most a hundredth of the tolerance.
 */

import { crc32, MOST_BYTES, deflate, inflate } from './packing.ts';

const VERSION = 8;
const SUM_BYTES = 4;
/** Number of characters that passes everywhere. */
const SHORT = 1_900;
/** Largest rounding step, relative to the tolerance. */
const PART = 0.01;
/** Largest distance of the first vertex from the origin, and of another from it, in steps. */
const [FARTHEST_ORIGIN, FARTHEST] = [2 ** 45, 2 ** 31 - 1];
/** Largest exact power of ten. */
const EXPONENTS = 22;
/** Lists of vertices in a mesh. */
const LISTS = ['faces', 'curves', 'tets'] as const;

/** Vertices of faces, curves and tetrahedra, or their number. */
type Lists<Kind> = { [list in (typeof LISTS)[number]]?: Kind };
interface MeshFile extends Lists<number[][]> {
  positions: number[][];
}
/** A mesh with counts in place of positions and lists. */
interface CountedMesh extends Lists<number> {
  positions: number;
}
interface HandleFile {
  /** a list, or a text of ranges */
  vertices: number[] | string;
  targets?: number[][];
}
/** What rounding reads of a scene; its other parts stay as they are. */
interface SceneFile {
  /** an example's is named only */
  mesh?: MeshFile | { file: string; faces?: undefined };
  handles?: HandleFile[];
  lesson?: unknown;
}
/** Rounding step: 1, 2 or 5 times a power of ten, so that rounded numbers are short. */
type Step = { factor: number; exponent: number };
/** A rounded mesh: its numbers, and the rest of it. */
interface Rounded {
  mesh: CountedMesh;
  /** the first vertex, in steps */
  origin: number[];
  numbers: Uint8Array<ArrayBuffer>;
}

/** Returns the error for a truncated or altered link. */
const damaged = () =>
  new Error(
    'The link is incomplete or damaged: it was probably truncated. Ask the sender for the link again, or for the scene file.',
  );

/**
 * @param given.example id of the example whose mesh the scene has
 * @param given.run whether to iterate after opening
 * @param given.tolerance in the unit of the mesh
 * @param given.name base name of the scene's files
 * @returns with the rounding step, if rounded
 */
export async function packScene({
  scene,
  example,
  run,
  tolerance,
  name,
}: {
  scene: SceneFile;
  example?: string;
  run: boolean;
  tolerance: number;
  name?: string;
}): Promise<{ code: string; rounded: number | null }> {
  // JSON omits undefined keys.
  const about = { example, run: run || undefined, name };
  const exact = await packed({ ...about, scene });
  const step = tolerance > 0 ? stepBelow(PART * tolerance) : null;
  const { mesh: unrounded, lesson } = scene;
  // A lesson's submission is compared with its mesh bit by bit.
  if (exact.length <= SHORT || !unrounded?.faces || lesson || !step)
    return { code: exact, rounded: null };
  const rounded = roundedMesh(unrounded, step);
  if (!rounded) return { code: exact, rounded: null };
  const { mesh, origin, numbers } = rounded;
  const handles = scene.handles?.map(roundedHandle(unrounded.positions, step));
  const rest = { ...about, step, origin, scene: { ...scene, mesh, handles } };
  const code = await packed(rest, numbers);
  if (code.length >= exact.length) return { code: exact, rounded: null };
  return { code, rounded: scaled(1, step) };
}

/** @returns rejects altered codes */
export async function unpackScene(
  code: string,
): Promise<{ text: string; example: string | null; run: boolean; name: string | null }> {
  const bytes = readCode(code);
  if (!bytes?.length) throw damaged();
  if (bytes[0] !== VERSION)
    throw new Error(
      'The link was made by another version of this page. Reload the page, or ask the sender for the scene file.',
    );
  const content = await inflate(bytes.subarray(1)).catch(() => {
    throw damaged();
  });
  if (!content) {
    const most = MOST_BYTES >> 20;
    throw new Error(`The link unpacks to more than ${most} MB. Ask the sender for the scene file.`);
  }
  const end = content.indexOf(10);
  const about = read(content.subarray(0, end));
  const { scene, example = null, run = false, name = null, step, origin } = about;
  const numbers = content.subarray(end + 1);
  if (step) scene.mesh = restoredMesh({ mesh: scene.mesh, origin, numbers }, step);
  return { text: JSON.stringify(scene), example, run, name };
}

/** The JSON of a link. */
function read(bytes: Uint8Array) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw damaged();
  }
}

/** @param numbers of the mesh, if rounded */
async function packed(about: unknown, numbers: Uint8Array<ArrayBuffer> = new Uint8Array()) {
  const content = await deflate(new Blob([JSON.stringify(about), '\n', numbers]));
  const bytes = new Uint8Array(1 + content.length + SUM_BYTES);
  bytes[0] = VERSION;
  bytes.set(content, 1);
  const sumAt = bytes.length - SUM_BYTES;
  new DataView(bytes.buffer).setUint32(sumAt, crc32(bytes.subarray(0, sumAt)));
  return base64url(bytes);
}

/** Returns the bytes without the checksum; null if the code was altered. */
function readCode(code: string) {
  let binary;
  try {
    binary = atob(code.replaceAll('-', '+').replaceAll('_', '/'));
  } catch {
    return null;
  }
  const all = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  // `atob` overlooks spaces and excess bits.
  if (all.length < SUM_BYTES || base64url(all) !== code) return null;
  const bytes = all.subarray(0, -SUM_BYTES);
  return new DataView(all.buffer).getUint32(bytes.length) === crc32(bytes) ? bytes : null;
}

function base64url(bytes: Uint8Array) {
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * Returns the largest step that is at most a length.
 * @param length above 0
 * @returns null if the power of ten is not exact
 */
function stepBelow(length: number): Step | null {
  const exponent = Math.floor(Math.log10(length));
  const factor = [5, 2, 1].find((one) => scaled(one, { factor: 1, exponent }) <= length);
  if (factor === undefined) return stepBelow(length * 0.99);
  return Math.abs(exponent) <= EXPONENTS ? { factor, exponent } : null;
}

/** Returns the length of `count` steps. */
function scaled(count: number, { factor, exponent }: Step) {
  const size = 10 ** Math.abs(exponent);
  // A quotient of exact integers is rounded once, to the double nearest to the decimal number.
  return exponent < 0 ? (count * factor) / size : count * factor * size;
}

/**
 * Rounds the positions of a mesh to a step. Its numbers are the coordinates of all vertices, one
 * axis after another, then the lengths of all lists, and their vertices.
 * @returns null if rounding would merge distinct vertices or exceed the range
 */
function roundedMesh(mesh: MeshFile, step: Step): Rounded | null {
  const { positions } = mesh;
  const length = scaled(1, step);
  const places = positions.map((at) => at.map((value) => Math.round(value / length)));
  const origin = [...places[0]];
  const isNear = (value: number, axis: number) =>
    Math.abs(origin[axis]) <= FARTHEST_ORIGIN && Math.abs(value - origin[axis]) <= FARTHEST;
  if (!places.every((at) => at.every(isNear))) return null;
  const apart = (points: number[][]) => new Set(points.map(String)).size;
  if (apart(places) < apart(positions)) return null;
  const along = origin.map((from, axis) => places.map((at) => at[axis] - from));
  const lists = LISTS.flatMap((key) => mesh[key] ?? []);
  const numbers = [...along, lists.map((list) => list.length), ...lists].flat();
  const { faces, curves, tets } = mesh;
  const counts = { faces: faces?.length, curves: curves?.length, tets: tets?.length };
  return {
    ...{ mesh: { ...mesh, positions: positions.length, ...counts }, origin },
    numbers: writeNumbers(Int32Array.from(numbers)),
  };
}

/** Returns the mesh with rounded positions. */
function restoredMesh({ mesh, origin, numbers }: Rounded, step: Step) {
  const all = readNumbers(numbers);
  let at = 0;
  const next = (count: number) => all.subarray(at, (at += count));
  const [x, y, z] = origin.map((from) =>
    Array.from(next(mesh.positions), (value) => scaled(from + value, step)),
  );
  const keys = LISTS.filter((key) => key in mesh);
  const lengths = keys.map((key) => next(mesh[key] ?? 0));
  const lists = keys.map((key, i) => [key, Array.from(lengths[i], (length) => [...next(length)])]);
  const positions = x.map((_, vertex) => [x[vertex], y[vertex], z[vertex]]);
  return { ...mesh, positions, ...Object.fromEntries(lists) };
}

/**
 * Writes the difference of each number to the one before, with its sign in the lowest bit: the
 * lowest bytes of all numbers first, the highest last, which are nearly all 0.
 */
function writeNumbers(numbers: Int32Array) {
  const count = numbers.length;
  const bytes = new Uint8Array(4 * count);
  numbers.forEach((value, i) => {
    const difference = (value - (numbers[i - 1] ?? 0)) | 0;
    const signed = (difference << 1) ^ (difference >> 31);
    for (let k = 0; k < 4; k++) bytes[k * count + i] = signed >>> (8 * k);
  });
  return bytes;
}

/** Reads what `writeNumbers` wrote. */
function readNumbers(bytes: Uint8Array) {
  const count = Math.floor(bytes.length / 4);
  const numbers = new Int32Array(count);
  for (let i = 0; i < count; i++) {
    let signed = 0;
    for (let k = 0; k < 4; k++) signed |= bytes[k * count + i] << (8 * k);
    numbers[i] = (numbers[i - 1] ?? 0) + ((signed >>> 1) ^ -(signed & 1));
  }
  return numbers;
}

/**
 * Returns a handle with rounded targets, or without if they are the rest positions (the default).
 */
function roundedHandle(positions: number[][], step: Step) {
  const length = scaled(1, step);
  return (handle: HandleFile): HandleFile => {
    const { targets, vertices } = handle;
    if (!targets) return handle;
    const isAtRest =
      Array.isArray(vertices) &&
      targets.every((target, i) => String(positions[vertices[i]]) === String(target));
    if (isAtRest) return { ...handle, targets: undefined };
    const rounded = targets.map((target) =>
      target.map((value) => scaled(Math.round(value / length), step)),
    );
    return { ...handle, targets: rounded };
  };
}
