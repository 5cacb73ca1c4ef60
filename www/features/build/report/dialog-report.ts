/** The dialog of the one-page report, to save as PDF or print. */

import './dialog-report.css';
import { linkTo } from '../../../documents/share-link.ts';
import { button } from '../../../ui/controls/fields.ts';
import { openDialog } from '../../../ui/controls/dialog.ts';
import { element } from '../../../ui/dom.ts';
import type { AppContext } from '../../../app/context.ts';
import type { LiveBuild } from '../live-build.ts';

export async function showReport(app: AppContext, live: LiveBuild) {
  const { store, files } = app;
  const { document: scene, camera } = store.get();
  const title = scene?.title || files.name;
  // Turn and tilt.
  const angles = camera ? Float64Array.from(camera.slice(4, 6)) : null;
  const { address } = await linkTo(app);
  const page = await live.reportPage({ title, camera: angles, link: address });
  if (!page) return;
  const picture = new DOMParser().parseFromString(page.svg, 'image/svg+xml').documentElement;
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', `Report on ${title}`);
  const save = button('Save as PDF', () => files.save('-report.pdf', page.pdf, 'application/pdf'), {
    class: 'primary',
  });
  openDialog(
    { id: 'parts-report', title: 'Report' },
    element(
      'div.report-body',
      element('div.report-paper', { tabindex: '0', role: 'group', 'aria-label': 'Page' }, picture),
      element(
        'div.dialog-buttons',
        save,
        button('Print', () => print()),
      ),
    ),
  );
  save.focus();
}
