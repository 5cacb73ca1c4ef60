/**
 * What a file input or a drop gives: one model of it, and words on what is left out. Comes when
 * somebody chooses files.
 */

import { messageOf } from '../../solver/messages.js';
import { isReadable, worthReading } from '../../solver/opened-files.js';

/** Bytes from which on it takes a while to read a file. */
const LARGE = 2_000_000;

/**
 * Opens what can be opened, or says what is wrong.
 * @param {import("../../app/context.js").AppContext} app
 * @param {File[]} chosen
 * @param {string[]} [folders] names of those that were dropped with them
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
 * Opens them together.
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
    const bytesOf = async (/** @type {File} */ file) => ({
      name: file.name,
      bytes: new Uint8Array(await file.arrayBuffer()),
    });
    return await open(await Promise.all(chosen.map(bytesOf)));
  } catch (error) {
    const names = chosen.map(({ name }) => name).join(' and ');
    alerts.error(`${names} could not be read from the disk (${messageOf(error)}).`);
  }
}

/** The name of the mesh in a file of Rhino. @param {string} name */
const meshName = (name) => name.replace(/\.3dm$/i, '.obj');

/**
 * What was taken of the files and folders that were given together, and why not the others.
 * @param {string[]} taken names
 * @param {string[]} files names of the others
 * @param {string[]} folders names
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
