/**
 * Files from the user: chosen, dropped on the window, or chosen because a scene names them. Files that
 * are left out are listed.
 */

import { messageOf } from '../solver/errors.ts';
import { isReadable, worthReading } from '../solver/opened-files.ts';
import { element } from '../ui/dom.ts';
import { FIT, readSecondFile } from '../store/second-files.ts';
import { openLarge } from './large-file-import.ts';
import type { AppContext } from '../app/context.ts';
import type { NamedBytes, Loaded } from '../solver/types.ts';
import type { Actions } from '../store/actions.ts';
import type { Offer } from '../ui/controls/alerts.ts';
import type { Files, Origin } from './files.ts';
import type { Opening } from './openings.ts';

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
async function read({ actions, files, alerts }: AppContext, opening: Opening, chosen: File[]) {
  const open: (given: NamedBytes[], cancelled?: AbortSignal) => Promise<Loaded | null> = (
    given,
    cancelled,
  ) => files.open(given, {}, { opening, cancelled }).catch(() => null);
  if (chosen.some(({ size }) => size > LARGE)) {
    return openLarge(chosen, { actions, alerts, open });
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

/** Below this fraction of the window's height, a drop sets the open model's reference surface. */
const FIT_FROM = 0.8;

/** Accepts drops; the overlay shows what a drop will do. */
export function acceptDrops(overlay: HTMLElement, app: AppContext) {
  const { store, actions } = app;
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  /** What is written in a dialog is about the open model. */
  const isRefused = () => document.querySelector('dialog:modal') !== null;
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (isRefused() && event.dataTransfer) event.dataTransfer.dropEffect = 'none';
    if (isRefused()) return;
    overlay.classList.toggle('fits', Boolean(store.get().document));
    overlay.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) overlay.hidden = true;
  });
  window.addEventListener('drop', (event) => {
    overlay.hidden = true;
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (isRefused()) return;
    const { files, items } = event.dataTransfer as DataTransfer;
    // A folder looks like an unreadable file.
    const [file] = files;
    if (store.get().document && event.clientY > FIT_FROM * window.innerHeight && file) {
      void actions.reportErrors(readSecondFile(FIT, file, actions));
      return;
    }
    const folders = [...items]
      .map((item) => item.webkitGetAsEntry())
      .flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    const chosen = [...files].filter(({ name }) => !folders.includes(name));
    const opened = app.files.openings.begin((opening) => openChosen(app, opening, chosen, folders));
    void actions.reportErrors(opened);
  });
}

/**
 * Returns an offer to choose the files that a scene names and that are missing; empty if none is.
 */
export async function offersToChoose(
  given: NamedBytes[],
  actions: Actions,
  files: Files,
  origin: Origin,
): Promise<Offer[]> {
  const missing = await actions.ask.missingFiles(given).catch(() => []);
  if (missing.length === 0) return [];
  const action = async () => {
    const chosen = await choose(missing);
    if (chosen.length === 0) return;
    const opened = files.openings.begin(async (opening) => {
      const read = readFor(missing, chosen);
      const found = await actions.reportErrors(read);
      if (found) await files.open([...given, ...found], origin, { opening });
    });
    // The alert gives the reason of a refusal.
    opened.catch(() => {});
  };
  return [{ label: `Choose ${missing.join(' and ')} …`, action }];
}

/**
 * Reads the files that were chosen for missing ones. A single one is taken for the missing one, whatever
 * its name, but not its ending, by which it is read.
 */
async function readFor([first, ...others]: string[], chosen: File[]) {
  const name = others.length === 0 ? first.split('/').pop() : undefined;
  const ending = endingOf(first);
  const other = chosen.find((file) => name && endingOf(file.name) !== ending);
  if (other)
    throw new Error(`${other.name} is of another format: the scene needs a ${ending} file.`);
  return Promise.all(chosen.map((file) => namedBytes(file, name)));
}

const endingOf = (name: string) => /\.[^./]*$/.exec(name)?.[0].toLowerCase() ?? '';

/** @returns empty if cancelled */
const choose = (missing: string[]): Promise<File[]> =>
  new Promise((done) => {
    const accept = [...new Set(missing.map(endingOf))].join();
    const input = element('input', { type: 'file', accept, multiple: missing.length > 1 });
    input.onchange = () => done([...(input.files ?? [])]);
    input.oncancel = () => done([]);
    input.click();
  });

/**
 * Reads a file.
 * @param name in place of its own
 */
async function namedBytes(file: File, name: string = file.name): Promise<NamedBytes> {
  return { name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
