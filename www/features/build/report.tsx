/** The dialog of the report: the document that the command line writes too, to print or save. */

import './report.css';
import { useEffect, useRef } from 'preact/hooks';
import { linkTo } from '../../documents/share-link.ts';
import { showDialog } from '../../store/show-dialog.tsx';
import { Button } from '../../ui/components/buttons.tsx';
import { TILT, TURN } from '../../viewport/flight.ts';
import type { AppContext } from '../../app/context.ts';
import type { LiveBuild } from './live-build.ts';

/** Scripts stay off; `allow-same-origin` and `allow-modals` let this page print the document. */
const SANDBOX = 'allow-same-origin allow-modals allow-popups allow-popups-to-escape-sandbox';

export async function showReport(app: AppContext, live: LiveBuild) {
  const { store, files, actions } = app;
  await actions.settled();
  const { document: scene, camera } = store.get();
  const title = scene?.title || files.name;
  const angles = camera && Float64Array.of(camera[TURN], camera[TILT]);
  const { address } = await linkTo(app);
  const text = await live.reportPage({ title, camera: angles, link: address });
  if (text === null) return;
  showDialog(app, { id: 'parts-report', title: 'Report' }, ({ close }) => {
    const page = useRef<HTMLIFrameElement>(null);
    const print = useRef<HTMLButtonElement>(null);
    useEffect(() => print.current?.focus(), []);
    return (
      <div class="report-body">
        <iframe
          ref={page}
          title={`Report on ${title}`}
          sandbox={SANDBOX}
          srcdoc={text}
          // Keys pressed in the frame do not reach the dialog.
          onLoad={({ currentTarget }) =>
            currentTarget.contentDocument?.addEventListener('keydown', ({ key }) => {
              if (key === 'Escape') close();
            })
          }
        />
        <div class="dialog-buttons">
          <button
            ref={print}
            type="button"
            class="primary"
            onClick={() => page.current?.contentWindow?.print()}
          >
            Print or save as PDF
          </button>
          <Button onClick={() => files.save('-report.html', 'text/html', () => text)}>
            Save as HTML
          </Button>
        </div>
      </div>
    );
  });
}
