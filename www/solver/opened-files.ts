/** Files opened together: the main one, those that it names, and those that are ignored. */

import type { NamedBytes } from './types.ts';

type Named = { name: string };

const isScene = ({ name }: Named) => /\.json$/i.test(name);

/** Whether the file can be a mesh or a scene, by its name. */
export const isReadable = ({ name }: Named) => /\.(obj|off|mesh|ply|stl|json|3dm)$/i.test(name);

/** Returns the first scene, or else the first file. */
export const mainOf = <File extends Named>(files: File[]) => files.find(isScene) ?? files[0];

/**
 * Returns the files to read: a scene and the files it may name, or one mesh. If there is none, the
 * first file, which is then refused with a reason.
 */
export function worthReading<File extends Named>(files: File[]) {
  const readable = files.filter(isReadable);
  const main = mainOf(readable);
  if (!main) return files.slice(0, 1);
  return isScene(main) ? [main, ...readable.filter((file) => !isScene(file))] : [main];
}

/**
 * Returns the paths that the main file names, each with the file of that name, if given.
 * @param namesOf returns the paths that a scene names
 * @throws if a file could be that of two paths: files have no folders here
 */
export function filesNamed(files: NamedBytes[], namesOf: (scene: Uint8Array) => string[]) {
  const main = mainOf(files);
  const paths = isScene(main) ? namesOf(main.bytes) : [];
  const others = files.filter((file) => file !== main);
  const takenBy: Map<NamedBytes, string> = new Map();
  return paths.map((path) => {
    const file = others.find(({ name }) => name === nameOf(path));
    const before = file && takenBy.get(file);
    if (before && withoutDots(before) !== withoutDots(path))
      throw new Error(
        `${before} and ${path} have the same name here, without their folders: rename one of them, also in the scene.`,
      );
    if (file) takenBy.set(file, path);
    return { path, file };
  });
}

const nameOf = (path: string) => path.split('/').pop();

/** A path in its shortest form. */
const withoutDots = (path: string) => path.replace(/(^|\/)(\.\/)+/g, '$1');
