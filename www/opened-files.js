/** Of files that are opened together: which one is opened, and which is the mesh that it names. */

/** @typedef {import("./messages.js").NamedBytes} NamedBytes */

const isScene = (/** @type {NamedBytes} */ { name }) => /\.json$/i.test(name);

/** The first scene, else the first file. @param {NamedBytes[]} files */
export const mainOf = (files) => files.find(isScene) ?? files[0];

/**
 * The mesh that goes with the main file: null where it needs none.
 * @param {NamedBytes[]} files
 * @param {(scene: Uint8Array) => string | undefined} meshOf the path of the mesh that a scene names
 */
export function companionOf(files, meshOf) {
  const main = mainOf(files);
  const wanted = isScene(main) && meshOf(main.bytes);
  if (!wanted) return null;
  const name = wanted.split('/').pop();
  const companion = files.find((file) => file !== main && file.name === name);
  if (!companion)
    throw new Error(`${main.name} needs the mesh file ${wanted}: open both files together`);
  return companion;
}
