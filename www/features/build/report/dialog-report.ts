/** The dialog of the report: the document that the command line writes too, to print or save. */

import './dialog-report.css';
import { linkTo } from '../../../documents/share-link.ts';
import { button } from '../../../ui/controls/fields.ts';
import { openDialog } from '../../../ui/controls/dialog.ts';
import { element } from '../../../ui/dom.ts';
import type { AppContext } from '../../../app/context.ts';
import type { LiveBuild } from '../live-build.ts';

/** Scripts stay off; `allow-same-origin` and `allow-modals` let this page print the document. */
const SANDBOX = 'allow-same-origin allow-modals allow-popups allow-popups-to-escape-sandbox';

export async function showReport(app: AppContext, live: LiveBuild) {
  const { store, files, actions } = app;
  await actions.settled();
  const { document: scene, camera } = store.get();
  const title = scene?.title || files.name;
  // Turn and tilt.
  const angles = camera ? Float64Array.from(camera.slice(4, 6)) : null;
  const { address } = await linkTo(app);
  const text = await live.reportPage({ title, camera: angles, link: address });
  if (text === null) return;
  const page = element('iframe', { title: `Report on ${title}`, sandbox: SANDBOX, srcdoc: text });
  const print = button('Print or save as PDF', () => page.contentWindow?.print(), {
    class: 'primary',
  });
  const save = button('Save as HTML', () => files.save('-report.html', text, 'text/html'));
  const dialog = openDialog(
    { id: 'parts-report', title: 'Report' },
    element('div.report-body', page, element('div.dialog-buttons', print, save)),
  );
  // Keys pressed in the frame do not reach the dialog.
  page.addEventListener('load', () =>
    page.contentDocument?.addEventListener('keydown', ({ key }) => {
      if (key === 'Escape') dialog.close();
    }),
  );
  print.focus();
}
