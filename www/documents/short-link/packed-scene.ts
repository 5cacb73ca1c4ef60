/**
 * Code of a link: a scene, whether to run it, and the id of the example whose mesh it has. Layout:
 * flags (1 byte), the length of the mesh code and that code, if any, and the rest as deflated JSON.
 *
 * If the unrounded scene gives a code short enough to pass everywhere, that code is used. Otherwise
 * the positions of the mesh and of its handles are rounded to at most a hundredth of the tolerance.
 */

import { readCode, writeCode } from './checked-code.ts';
import { damaged, deflate, inflate } from './deflated.ts';
import { readMesh, scaled, stepBelow, writeMesh, type Step } from './mesh-code.ts';

export { inflated } from './deflated.ts';

/** Number of characters that passes everywhere. */
const SHORT = 1_900;
/** Largest rounding step, relative to the tolerance. */
const PART = 0.01;
/** Flags of the first byte. */
const RUN = 1;
const HAS_MESH = 2;
/** Positions were coded with plane prediction, unlike in the first links. */
const IN_PLANES = 4;
const LENGTH_BYTES = 4;

type SceneFile = Record<string, any>;

/**
 * @param given.tolerance in the unit of the mesh
 * @returns with the rounding step, if rounded
 */
export async function packScene({
  scene,
  example,
  run,
  tolerance,
}: {
  scene: SceneFile;
  example?: string;
  run: boolean;
  tolerance: number;
}): Promise<{ code: string; rounded: number | null }> {
  const exact = await packed({ scene, example }, run, null);
  const step = tolerance > 0 ? stepBelow(PART * tolerance) : null;
  // A lesson's submission is compared with its mesh bit by bit.
  if (exact.length <= SHORT || !scene.mesh?.faces || scene.lesson || !step)
    return { code: exact, rounded: null };
  const { positions, faces, ...others } = scene.mesh;
  const mesh = writeMesh({ positions, faces }, step);
  const handles = scene.handles?.map(roundedHandle(positions, step));
  // JSON omits undefined keys.
  const rest = { ...scene, mesh: others, handles };
  const code = mesh && (await packed({ scene: rest, example }, run, mesh));
  if (!code || code.length >= exact.length) return { code: exact, rounded: null };
  return { code, rounded: scaled(1, step) };
}

async function packed(content: unknown, run: boolean, mesh: Uint8Array | null) {
  const text = await deflate(JSON.stringify(content));
  const head = new DataView(new ArrayBuffer(1 + (mesh ? LENGTH_BYTES : 0)));
  head.setUint8(0, (run ? RUN : 0) | (mesh ? HAS_MESH | IN_PLANES : 0));
  if (mesh) head.setUint32(1, mesh.length);
  const parts = [new Uint8Array(head.buffer), mesh ?? new Uint8Array(), text];
  return writeCode(Uint8Array.from(parts.flatMap((part) => [...part])));
}

/** @returns rejects altered codes */
export async function unpackScene(
  code: string,
): Promise<{ text: string; example: string | null; run: boolean }> {
  const bytes = readCode(code);
  if (!bytes?.length) throw damaged();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const holds = view.getUint8(0);
  if (holds > (RUN | HAS_MESH | IN_PLANES))
    throw new Error('The link was made by a newer version of this page. Reload the page.');
  const run = (holds & RUN) !== 0;
  if (!(holds & HAS_MESH)) {
    const { scene, example = null } = JSON.parse(await inflate(bytes.subarray(1)));
    return { text: JSON.stringify(scene), example, run };
  }
  const start = 1 + LENGTH_BYTES;
  const end = start + view.getUint32(1);
  const { scene } = JSON.parse(await inflate(bytes.subarray(end)));
  const { positions, faces } = readMesh(bytes.subarray(start, end), (holds & IN_PLANES) !== 0);
  // The remaining keys of the mesh are curves, tetrahedra and groups.
  const mesh = { positions, faces, ...scene.mesh };
  return { text: JSON.stringify({ ...scene, mesh }), example: null, run };
}

/**
 * Returns a handle with rounded targets, or without if they are the rest positions (the default).
 */
function roundedHandle(positions: number[][], step: Step) {
  const length = scaled(1, step);
  return (handle: SceneFile) => {
    const { targets, vertices } = handle;
    if (!targets) return handle;
    const isAtRest = (target: number[], i: number) =>
      String(positions[vertices[i]]) === String(target);
    if (Array.isArray(vertices) && targets.every(isAtRest))
      return { ...handle, targets: undefined };
    const rounded = targets.map((target: number[]) =>
      target.map((value) => scaled(Math.round(value / length), step)),
    );
    return { ...handle, targets: rounded };
  };
}
