/** Opens a model from a file input or a drop, and lists the files left out. */

import { messageOf } from '../../solver/errors.ts';
import type { NamedBytes, Loaded } from '../../solver/types.ts';
import { isReadable, worthReading } from '../../solver/opened-files.ts';
import { openLarge } from './large-file-import.ts';
import { namedBytes } from './named-bytes.ts';
import type { Opening } from './openings.ts';
import type { AppContext } from '../../app/context.ts';

/** Size in bytes from which a progress display is shown. */
const LARGE = 2_000_000;

/**
 * Opens the readable files, or reports the error.
 * @param folders names of the folders dropped with them
 */
export async function openChosen(
  app: AppContext,
  opening: Opening,
  chosen: File[],
  folders: string[] = [],
) {
  const { alerts } = app;
  const wanted = worthReading(chosen);
  if (wanted.length === 0) {
    const [name] = folders;
    if (name) alerts.error(`${name} is a folder. Open the files in it instead.`);
    return;
  }
  const loaded = await read(app, opening, wanted);
  if (!loaded) return;
  const isTaken = (file: File) =>
    wanted.includes(file) && loaded.files.includes(meshName(file.name));
  const others = chosen.filter((file) => !isTaken(file)).map(({ name }) => name);
  if (others.length + folders.length === 0) return;
  const taken = wanted.filter(isTaken).map(({ name }) => name);
  alerts.notice(leftOut(taken, others, folders));
}

/** Reads the files and opens them together. */
async function read(
  { actions, solver, files, alerts }: AppContext,
  opening: Opening,
  chosen: File[],
) {
  const open: (given: NamedBytes[], cancelled?: AbortSignal) => Promise<Loaded | null> = (
    given,
    cancelled,
  ) => files.open(given, {}, { opening, cancelled }).catch(() => null);
  if (chosen.some(({ size }) => size > LARGE)) {
    return openLarge(chosen, { actions, solver, alerts, open });
  }
  try {
    return await open(await Promise.all(chosen.map((file) => namedBytes(file))));
  } catch (error) {
    if (!(await opening.isWanted())) return null;
    const names = chosen.map(({ name }) => name).join(' and ');
    alerts.error(`${names} could not be read from the disk (${messageOf(error)}).`);
  }
}

/** Returns the name of the mesh read from a Rhino file. */
const meshName = (name: string) => name.replace(/\.3dm$/i, '.obj');

/**
 * Lists the opened files and the omitted files and folders, with the reasons.
 * @param taken names
 * @param files names of the omitted files
 * @param folders names of the omitted folders
 */
function leftOut(taken: string[], files: string[], folders: string[]) {
  const reasons = [
    ...files.map((name) => {
      const reason = isReadable({ name }) ? 'one model at a time' : 'neither a mesh nor a scene';
      return `${name} (${reason})`;
    }),
    ...folders.map((name) => `${name} (a folder: open the files in it)`),
  ];
  return `Opened ${taken.join(' with ')}. Left out: ${reasons.join(', ')}.`;
}
