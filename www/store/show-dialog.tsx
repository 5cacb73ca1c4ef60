/** Dialogs. */

import '../ui/styles/dialog.css';
import { createRef, render, type ComponentType } from 'preact';
import { CloseButton } from '../ui/components/buttons.tsx';
import { closeAboutModel } from '../ui/controls/dialog.ts';
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

/**
 * Opens a dialog with a title and a button that closes it, and removes it when it is closed. The one that
 * a quick second press asks for takes the place of the first.
 * @param about `light`: a click outside closes it; `lasts`: it is not about the open model
 */
export function showDialog(
  app: AppContext,
  {
    id,
    title,
    light = false,
    lasts = false,
  }: { id: string; title: string; light?: boolean; lasts?: boolean },
  Content: ComponentType<InDialog>,
) {
  const before = document.getElementById(id);
  if (before instanceof HTMLDialogElement) before.close();
  const host = document.createElement('div');
  host.className = 'hosted';
  const dialog = createRef<HTMLDialogElement>();
  const close = () => dialog.current?.close();
  // A drag that selects text may end outside.
  let isBegunOutside = false;
  render(
    <AppProvider value={app}>
      <dialog
        ref={dialog}
        id={id}
        aria-labelledby={`${id}-title`}
        data-about={lasts ? undefined : 'model'}
        onClose={() => {
          render(null, host);
          host.remove();
        }}
        onPointerDown={({ target }) => (isBegunOutside = target === dialog.current)}
        onClick={({ target }) => light && isBegunOutside && target === dialog.current && close()}
      >
        <div class="dialog-head">
          <h2 id={`${id}-title`}>{title}</h2>
          <CloseButton class="square" label="Close" onClick={close} />
        </div>
        <div class="hosted">
          <Content close={close} />
        </div>
      </dialog>
    </AppProvider>,
    host,
  );
  document.body.append(host);
  // With its content: it gives the focus to what has `autofocus` there.
  dialog.current?.showModal();
}
