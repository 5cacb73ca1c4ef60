/** The view while no model is open, because not even the first example could be fetched. */

import './style/waiting.css';
import { byId, element } from './dom.js';
import { removeFirstPicture } from './first-picture.js';

/**
 * Says what can be opened, until something is.
 * @param {import("./files.js").Files} files
 * @param {() => Promise<void>} again opens the first example
 */
export function showNothingOpen(files, again) {
  removeFirstPicture();
  byId('hint-card').hidden = true;
  byId('model').replaceChildren(element('p', { class: 'quiet' }, 'Nothing is open.'));
  const card = element(
    'div',
    { id: 'nothing-open' },
    element('p', {}, 'Drop a mesh (.obj, .off, .mesh, .3dm) or a scene (.json) here.'),
    element('button', { type: 'button', class: 'bordered', onclick: again }, 'Open a sample'),
  );
  byId('main').append(card);
  files.addEventListener('opened', () => card.remove(), { once: true });
}
