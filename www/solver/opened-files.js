/** Of files that are opened together: which one is opened, which is the mesh that it names, and which are not read. */

/** @typedef {import("./messages.js").NamedBytes} NamedBytes */

/** @typedef {{ name: string }} Named */

const isScene = (/** @type {Named} */ { name }) => /\.json$/i.test(name);

/** Whether it can be a mesh or a scene, by its name. @param {Named} file */
export const isReadable = ({ name }) => /\.(obj|off|mesh|json|3dm)$/i.test(name);

/**
 * The first scene, else the first file.
 * @template {Named} File
 * @param {File[]} files
 */
export const mainOf = (files) => files.find(isScene) ?? files[0];

/**
 * The files that are worth reading: a scene and what may be its mesh, or one mesh. Where none is, the
 * first one, which is refused with the reason.
 * @template {Named} File
 * @param {File[]} files
 */
export function worthReading(files) {
  const readable = files.filter(isReadable);
  const main = mainOf(readable);
  if (!main) return files.slice(0, 1);
  return isScene(main) ? [main, ...readable.filter((file) => !isScene(file))] : [main];
}

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
