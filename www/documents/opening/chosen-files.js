/** Opens a model from a file input or a drop, and lists the files left out. Loaded on demand. */

import { messageOf } from '../../solver/messages.js';
import { isReadable, worthReading } from '../../solver/opened-files.js';
import { namedBytes } from './named-bytes.js';

/** Size in bytes from which a progress display is shown. */
const LARGE = 2_000_000;

/**
 * Opens the readable files, or reports the error.
 * @param {import("../../app/context.js").AppContext} app
 * @param {File[]} chosen
 * @param {string[]} [folders] names of the folders dropped with them
 */
export async function openChosen(app, chosen, folders = []) {
  const { alerts } = app;
  const wanted = worthReading(chosen);
  if (wanted.length === 0) {
    const [name] = folders;
    if (name) alerts.error(`${name} is a folder. Open the files in it instead.`);
    return;
  }
  const loaded = await read(app, wanted);
  if (!loaded) return;
  const isTaken = (/** @type {File} */ file) =>
    wanted.includes(file) && loaded.files.includes(meshName(file.name));
  const others = chosen.filter((file) => !isTaken(file)).map(({ name }) => name);
  if (others.length + folders.length === 0) return;
  const taken = wanted.filter(isTaken).map(({ name }) => name);
  alerts.notice(leftOut(taken, others, folders));
}

/**
 * Reads the files and opens them together.
 * @param {import("../../app/context.js").AppContext} app
 * @param {File[]} chosen
 */
async function read({ actions, solver, files, alerts }, chosen) {
  /** @type {(given: import("../../solver/messages.js").NamedBytes[], cancelled?: AbortSignal) => Promise<import("../../solver/messages.js").Loaded | undefined>} */
  const open = (given, cancelled) => files.open(given, {}, cancelled).catch(() => undefined);
  if (chosen.some(({ size }) => size > LARGE)) {
    const { openLarge } = await import('./large-file-import.js');
    return openLarge(chosen, { actions, solver, alerts, open });
  }
  try {
    return await open(await Promise.all(chosen.map((file) => namedBytes(file))));
  } catch (error) {
    const names = chosen.map(({ name }) => name).join(' and ');
    alerts.error(`${names} could not be read from the disk (${messageOf(error)}).`);
  }
}

/** Returns the name of the mesh read from a Rhino file. @param {string} name */
const meshName = (name) => name.replace(/\.3dm$/i, '.obj');

/**
 * Lists the opened files and the omitted files and folders, with the reasons.
 * @param {string[]} taken names
 * @param {string[]} files names of the omitted files
 * @param {string[]} folders names of the omitted folders
 */
function leftOut(taken, files, folders) {
  const reasons = [
    ...files.map((name) => {
      const reason = isReadable({ name }) ? 'one model at a time' : 'neither a mesh nor a scene';
      return `${name} (${reason})`;
    }),
    ...folders.map((name) => `${name} (a folder: open the files in it)`),
  ];
  return `Opened ${taken.join(' with ')}. Left out: ${reasons.join(', ')}.`;
}
