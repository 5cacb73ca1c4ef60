/**
 * Links that carry a scene. All of it is in the fragment, which never leaves the browser:
 *
 * | fragment | is |
 * |---|---|
 * | `#example=ID`, `#example=ID&run` | an example as it comes; `&run` iterates after opening |
 * | `#link=CODE` | a scene with its mesh, or with that of an example, see `short-link/packed-scene.js` |
 * | `#scene=CODE`, `#example=ID&edits=CODE` | the same in links of earlier versions, see `short-link/deflated.js` |
 *
 * The current positions are in none of them: what was solved is solved again, so that no rounded result stands
 * beside its errors. A design that was kept is in the scene: it is where the scene starts.
 */

/** @typedef {import("./files.js").Example} Example */

/**
 * What a fragment says.
 * @typedef {object} Linked
 * @property {string | null} example id of the example whose mesh it has
 * @property {string | null} text of the scene, where it is not that of the example
 * @property {boolean} run iterates after opening
 */

/**
 * @param {string} hash of an address, with its #
 * @returns {Promise<Linked | null>} null when it is not a link of this page; rejects where it was cut or changed
 */
export async function readLink(hash) {
  const parts = new URLSearchParams(hash.slice(1));
  const code = parts.get('link');
  if (code !== null) return (await packing()).unpackScene(code);
  const example = parts.get('example');
  const earlier = parts.get('scene') ?? parts.get('edits');
  if (!example && !earlier) return null;
  return {
    example,
    text: earlier && (await (await packing()).inflated(earlier)),
    run: parts.has('run'),
  };
}

/**
 * The address that opens the scene as it is now, and to what its positions are rounded in it.
 * @param {Pick<import("../app/context.js").AppContext, "store" | "actions" | "files">} app
 */
export async function linkTo({ store, actions, files }) {
  const text = await actions.sceneText();
  const { numbers, tolerance, model } = store.get();
  const { example } = files.origin;
  const { variants, current } = JSON.parse(text);
  // A design that was kept is as exact as it was.
  const isKept = variants?.design !== undefined && !current;
  const run = (numbers?.iteration ?? 0) > 0 && !isKept;
  const about = { example, original: files.original, run };
  const { fragment, rounded } = await writeLink(text, {
    ...about,
    tolerance: tolerance ?? model?.tolerance ?? 0,
  });
  return { address: new URL(fragment, location.href.split('#')[0]).href, rounded };
}

/**
 * The fragment of a link to a scene.
 * @param {string} text of the scene with its mesh
 * @param {object} about
 * @param {Example} [about.example] whose mesh it has
 * @param {string | null} about.original text of the scene as the example came
 * @param {boolean} about.run
 * @param {number} about.tolerance in the unit of the mesh
 * @returns {Promise<{ fragment: string, rounded: number | null }>} with the step that positions are rounded to, if they are
 */
export async function writeLink(text, { example, original, run, tolerance }) {
  const scene = withoutPositions(text);
  const { packScene } = await packing();
  if (!example) {
    const { code, rounded } = await packScene({ scene, run, tolerance });
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

/** Most links that are opened are only the name of an example. */
const packing = () => import('./short-link/packed-scene.js');

/** @param {string} text of a scene */
function withoutPositions(text) {
  const scene = JSON.parse(text);
  delete scene.current;
  return scene;
}
