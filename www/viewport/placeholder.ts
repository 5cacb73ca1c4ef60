/** What is in place of the view: the first picture, or the reason why nothing can draw. */

import { byId, element } from '../ui/dom.ts';

/**
 * The picture of the first example in `index.html`, which covers the view until it has drawn or
 * another model is opened.
 */
const find = () => document.getElementById('first-picture');

export const isFirstPictureShown = () => find() !== null;

export function removeFirstPicture() {
  find()?.remove();
}

const NEVER =
  'this browser supports neither WebGPU nor WebGL2, or they are switched off in its settings.';
const GONE = 'the graphics context was lost repeatedly. Reloading the page may restore it.';
const NOT_HERE = 'the drawing module could not be loaded. Check the network, then reload the page.';

/**
 * Says that nothing can draw: the cause, and what still works.
 * @param reason error message of the browser
 */
export function explainNoPicture(reason: string) {
  const cause = /was lost/.test(reason) ? GONE : /fetched/.test(reason) ? NOT_HERE : NEVER;
  const notice = byId('no-picture');
  notice.replaceChildren(
    element('p', `No 3D view: ${cause} The steps, Run and Export still work.`),
    element('details', element('summary', 'Browser message'), element('p', reason)),
  );
  notice.hidden = false;
  byId('view-buttons').hidden = true;
}
