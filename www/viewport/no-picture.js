/** Message in place of the view if nothing can draw: the cause, and what still works. */

import { byId, element } from '../ui/dom.js';

const NEVER =
  'this browser draws neither with WebGPU nor with WebGL2, or it is switched off in its settings.';
const GONE =
  'the graphics card took it away again and again. Reloading the page may bring it back.';
const NOT_HERE =
  'the part that draws could not be fetched. Check the network, then reload the page.';

/** @param {string} reason error message of the browser */
export function explainNoPicture(reason) {
  const cause = /was lost/.test(reason) ? GONE : /fetched/.test(reason) ? NOT_HERE : NEVER;
  const notice = byId('no-picture');
  notice.replaceChildren(
    element('p', `No 3D view: ${cause} Everything else works: the panels, Run, and Export.`),
    element('details', element('summary', 'Message of the browser'), element('p', reason)),
  );
  notice.hidden = false;
  byId('view-buttons').hidden = true;
}
