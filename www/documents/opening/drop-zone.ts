/** Files dropped on the window: opened, or used as the reference surface. */

import { openChosen } from './chosen-files.ts';
import { fitTo } from './fit-to.ts';
import type { AppContext } from '../../app/context.ts';

/** Below this fraction of the window's height, a drop sets the open model's reference surface. */
const FIT_FROM = 0.8;

/** Accepts drops; the overlay shows what a drop will do. */
export function acceptDrops(overlay: HTMLElement, app: AppContext) {
  const { store, actions } = app;
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
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
    const { files, items } = event.dataTransfer as DataTransfer;
    // A folder looks like an unreadable file.
    const [file] = files;
    if (store.get().document && event.clientY > FIT_FROM * window.innerHeight && file) {
      void actions.reportErrors(fitTo(file, actions));
      return;
    }
    const folders = [...items]
      .map((item) => item.webkitGetAsEntry())
      .flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    const chosen = [...files].filter(({ name }) => !folders.includes(name));
    const opened = app.files.openings.begin((opening) =>
      openChosen(app, opening, chosen, folders),
    );
    void actions.reportErrors(opened);
  });
}
