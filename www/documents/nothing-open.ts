/** The view when no model is open because not even the first example could be fetched. */

import '../ui/styles/waiting.css';
import { byId, element } from '../ui/dom.ts';
import { removeFirstPicture } from '../viewport/first-picture.ts';
import type { Files } from './files.ts';

const FILES = 'a mesh (.obj, .off, .mesh, .3dm) or a scene (.json)';

/**
 * Shows what can be opened, until a model is opened.
 * @param again opens the first example
 */
export function showNothingOpen(files: Files, again: () => Promise<void>) {
  removeFirstPicture();
  byId('hint-card').hidden = true;
  byId('model').replaceChildren(element('p.quiet', 'Nothing is open.'));
  const card = element(
    'div',
    { id: 'nothing-open' },
    element('p.with-drop', `Drop ${FILES} here.`),
    element('p.without-drop', `Open ${FILES}.`),
    element('button.bordered', { onclick: again }, 'Open an example'),
  );
  byId('main').append(card);
  files.once('opened', () => card.remove());
}
