/**
 * Links that carry a scene. The data is in the fragment, which never leaves the browser:
 *
 * | fragment | content |
 * |---|---|
 * | `#example=ID`, `#example=ID&run` | an unchanged example; `&run` iterates after opening |
 * | `#link=CODE` | a scene with its mesh, or with an example's; see `link-code.ts` |
 *
 * No link contains the current positions: the receiver solves again, so that the errors shown are
 * not those of rounded positions. A kept design is part of the scene, as its start positions.
 */

import { packScene, unpackScene } from './link-code.ts';
import { sceneOf, type SceneText } from '../solver/scene-text.ts';
import type { Example, Files } from './files.ts';
import type { AppContext } from '../app/context.ts';

/** Content of a fragment. */
interface Linked {
  /** id of the example whose mesh it has */
  example: string | null;
  /** of the scene, unless it is the example's */
  text: string | null;
  /** whether to iterate after opening */
  run: boolean;
  /** base name of the scene's files, if the mesh is no example's */
  name: string | null;
}

/**
 * @param hash fragment of an address, with its #
 * @returns null if it is no link of this page; rejects if it was altered,
 *   or made by another version
 */
export async function readLink(hash: string): Promise<Linked | null> {
  const parts = new URLSearchParams(hash.slice(1));
  const code = parts.get('link');
  if (code !== null) return unpackScene(code);
  const example = parts.get('example');
  return example ? { example, text: null, run: parts.has('run'), name: null } : null;
}

/**
 * Returns the address of the workbench, without the options that this page was opened with: another
 * window is no embedded view, and draws as its own machine can.
 */
export const pageAddress = () => new URL('./', location.href.split(/[?#]/)[0]).href;

/** Returns the address that opens the current scene, and the rounding step of its positions. */
export async function linkTo({
  store,
  actions,
  files,
}: Pick<AppContext, 'store' | 'actions' | 'files'>) {
  const text = await actions.ask.scene();
  const { document: scene } = store.get();
  const { mesh, current } = sceneOf(text);
  const { origin } = files;
  const example = (await isUnchanged(mesh, files)) ? origin.example : undefined;
  // The link has no positions: a shape that is not that of the original, nor a kept one, is run again.
  const run = current !== undefined;
  const original = origin.edited ? null : files.original;
  const about = { example, original, run, name: files.name };
  const { fragment, rounded } = await writeLink(text, {
    ...about,
    tolerance: scene?.tolerance ?? 0,
  });
  return { address: pageAddress() + fragment, rounded };
}

/** Whether a mesh is still that of its example: refining and other edits of the mesh change it. */
async function isUnchanged({ positions, faces = [], tets }: SceneText['mesh'], files: Files) {
  const { example } = files.origin;
  // The solver changes no mesh of tetrahedra.
  if (!example || tets) return true;
  const bytes = await files.exampleFile(example.mesh).catch(() => null);
  const rows = new TextDecoder().decode(bytes ?? undefined).split(/\r?\n/);
  const numbers = (letter: string) =>
    rows.filter((row) => row.startsWith(letter)).map((row) => row.slice(2).split(' ').map(Number));
  const before = [numbers('v '), numbers('f ').map((face) => face.map((corner) => corner - 1))];
  return JSON.stringify(before) === JSON.stringify([positions, faces]);
}

/**
 * Returns the fragment of a link to a scene.
 * @param text scene with its mesh
 * @param about.example whose mesh the scene has
 * @param about.original text of the unchanged example
 * @param about.tolerance in the unit of the mesh
 * @param about.name base name of the scene's files
 * @returns with the rounding step, if rounded
 */
export async function writeLink(
  text: string,
  {
    example,
    original,
    run,
    tolerance,
    name,
  }: {
    example?: Example;
    original: string | null;
    run: boolean;
    tolerance: number;
    name?: string;
  },
): Promise<{ fragment: string; rounded: number | null }> {
  const scene = withoutPositions(text);
  if (!example) {
    const { code, rounded } = await packScene({ scene, run, tolerance, name });
    return { fragment: `#link=${code}`, rounded };
  }
  const edits = { ...scene, mesh: { file: example.mesh } };
  const before = original && { ...withoutPositions(original), mesh: { file: example.mesh } };
  if (before && JSON.stringify(before) === JSON.stringify(edits)) {
    const fragment = `#example=${encodeURIComponent(example.id)}${run ? '&run' : ''}`;
    return { fragment, rounded: null };
  }
  const { code } = await packScene({ scene: edits, example: example.id, run, tolerance });
  return { fragment: `#link=${code}`, rounded: null };
}

/** Whether two scenes are the same but for how far they are solved, of which a link has nothing. */
export const areSameUnsolved = (text: string, other: string) =>
  JSON.stringify(withoutPositions(text)) === JSON.stringify(withoutPositions(other));

/** @param text of a scene */
function withoutPositions(text: string) {
  const scene = sceneOf(text);
  delete scene.current;
  return scene;
}
