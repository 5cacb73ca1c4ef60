/** Of files that are opened together: which one is opened, which are those that it names, and which are not read. */

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
 * The files that are worth reading: a scene and what it may name, or one mesh. Where none is, the
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
 * The files that the main one names, each with the one of `files` that has its name, if there is one.
 * @param {NamedBytes[]} files
 * @param {(scene: Uint8Array) => string[]} namesOf the paths that a scene names
 */
export function filesNamed(files, namesOf) {
  const main = mainOf(files);
  const paths = isScene(main) ? namesOf(main.bytes) : [];
  const isOther = (/** @type {Named} */ file) => file !== main;
  return paths.map((path) => {
    const name = path.split('/').pop();
    return { path, file: files.filter(isOther).find((file) => file.name === name) };
  });
}
