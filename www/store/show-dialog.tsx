/** Dialogs whose content is a component. */

import { render, type ComponentType } from 'preact';
import { closeAboutModel, openDialog } from '../ui/controls/dialog.ts';
import { AppProvider } from './use-app.ts';
import type { AppContext } from '../app/context.ts';

/** What a dialog gives to its content. */
export interface InDialog {
  close: () => void;
}

/** Prepares and opens a dialog; once more if the model has changed meanwhile and it is about that. */
export async function openPrepared({ store }: Pick<AppContext, 'store'>, open: () => unknown) {
  const { model } = store.get();
  await open();
  if (store.get().model !== model && closeAboutModel()) await open();
}

/** Opens a dialog, and removes it and its content when it is closed. */
export function showDialog(
  app: AppContext,
  about: Parameters<typeof openDialog>[0],
  Content: ComponentType<InDialog>,
) {
  const place = document.createElement('div');
  place.className = 'hosted';
  render(
    <AppProvider value={app}>
      <Content close={() => place.closest('dialog')?.close()} />
    </AppProvider>,
    place,
  );
  // With its content: the dialog gives the focus to what has `autofocus` there.
  openDialog(about, place).addEventListener('close', () => render(null, place));
}
