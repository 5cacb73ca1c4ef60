/** Files from the user: chosen or dropped on the window. Files that are left out are listed. */

import { messageOf } from '../solver/errors.ts';
import { isReadable, worthReading } from '../solver/opened-files.ts';
import { isLocked } from '../store/panels-card.ts';
import { FIT, readSecondFile } from '../store/second-files.ts';
import { openLarge } from './large-file-import.ts';
import { namedBytes } from './missing-files.ts';
import type { AppContext } from '../app/context.ts';
import type { NamedBytes, Opened } from '../solver/types.ts';
import type { Large } from './files.ts';
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
  const open = (given: NamedBytes[], large?: Large): Promise<Opened | null> =>
    files.open(given, {}, { opening, large }).catch(() => null);
  if (chosen.some(({ size }) => size > LARGE)) {
    return openLarge(chosen, { actions, alerts, open, overtaken: opening.overtaken });
  }
  try {
    return await open(await Promise.all(chosen.map((file) => namedBytes(file))));
  } catch (error) {
    if (!(await opening.isWanted())) return null;
    alerts.error(messageOf(error));
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

/** Below this fraction of the window's height, one file is the open model's reference surface. */
const FIT_FROM = 0.8;

/** Accepts drops; the overlay shows what a drop will do. */
export function acceptDrops(overlay: HTMLElement, app: AppContext) {
  const { store, actions } = app;
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  /** What is written in a dialog is about the open model. */
  const isRefused = () => document.querySelector('dialog:modal') !== null;
  const canFit = () => {
    const state = store.get();
    return state.document !== null && !isLocked(state, 'weights') && !isLocked(state, 'mesh');
  };
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (isRefused() && event.dataTransfer) event.dataTransfer.dropEffect = 'none';
    if (isRefused()) return;
    const isOne = (event.dataTransfer?.items.length ?? 1) <= 1;
    overlay.classList.toggle('fits', isOne && canFit());
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
    const folders = [...items]
      .map((item) => item.webkitGetAsEntry())
      .flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    const chosen = [...files].filter(({ name }) => !folders.includes(name));
    const isBelow = event.clientY > FIT_FROM * window.innerHeight;
    // The surface is one file: several are a model, as anywhere else.
    if (store.get().document && isBelow && files.length === 1 && chosen.length === 1) {
      void actions.reportErrors(readSecondFile(FIT, chosen[0], app));
      return;
    }
    const opened = app.files.openings.begin((opening) => openChosen(app, opening, chosen, folders));
    void actions.reportErrors(opened);
  });
}
