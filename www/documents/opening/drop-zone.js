/** Files that are dropped anywhere on the window: opened, or fitted to. */

/** What is dropped below this part of the window is fitted to, where a model is open. */
const FIT_FROM = 0.8;

/**
 * Takes drops; the overlay says what will happen.
 * @param {HTMLElement} overlay
 * @param {import("../../app/context.js").AppContext} app
 */
export function acceptDrops(overlay, app) {
  const { store, actions } = app;
  const carriesFiles = (/** @type {DragEvent} */ event) =>
    event.dataTransfer?.types.includes('Files') ?? false;
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
    const { files, items } = /** @type {DataTransfer} */ (event.dataTransfer);
    // A folder looks like a file that cannot be read.
    const [file] = files;
    if (store.get().document && event.clientY > FIT_FROM * window.innerHeight && file) {
      actions.reportErrors(import('./fit-to.js').then((it) => it.fitTo(file, actions)));
      return;
    }
    const folders = [...items]
      .map((item) => item.webkitGetAsEntry())
      .flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    const chosen = [...files].filter(({ name }) => !folders.includes(name));
    const opened = import('./chosen-files.js').then((it) => it.openChosen(app, chosen, folders));
    actions.reportErrors(app.files.expect(opened));
  });
}
