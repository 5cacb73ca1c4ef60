/** The poster of an embedded view until the user starts it: a picture, a button and a link. */

import { CALLED, PRESSED, callIn, post } from '../../features/embed/protocol.js';
import { readLink } from '../../documents/share-link.js';
import { listOfExamples } from '../../solver/examples.js';
import { messageOf } from '../../solver/messages.js';
import { byId, setText } from '../../ui/dom.js';

const { hash, search } = location;
/** @type {HTMLAnchorElement} */ (byId('home')).href = `./${hash}`;
byId('start').addEventListener('click', () => start(PRESSED));

addEventListener('message', (event) => {
  const call = callIn(event);
  if (!call) return;
  const { id } = call;
  if (call.name === 'start') {
    post({ shapeUp: 'answer', id }, event.origin);
    start(CALLED);
  } else post({ shapeUp: 'answer', id, error: 'The view has not been started.' }, event.origin);
});
post({ shapeUp: 'news', news: 'waiting' });

readLink(hash).then(
  (link) =>
    link?.example
      ? showExample(link.example, link.run || link.text ? 'start' : 'end')
      : setText(byId('title'), 'A mesh to shape'),
  (error) => setText(byId('trouble'), messageOf(error)),
);

/** Replaces this page by the view, with the same options. @param {string} how */
function start(how) {
  const options = new URLSearchParams(search);
  options.set('embed', how);
  location.replace(`./?${options}${hash}`);
}

/**
 * @param {string} id
 * @param {"start" | "end"} pose
 */
async function showExample(id, pose) {
  try {
    const example = (await listOfExamples()).find((one) => one.id === id);
    if (!example)
      throw new Error(`There is no example called ${id}. The link is outdated or mistyped.`);
    setText(byId('title'), example.title);
    const picture = /** @type {HTMLImageElement} */ (byId('picture'));
    picture.src = `pictures/${example.id}-${pose}.webp`;
    picture.alt = example.title;
    picture.hidden = false;
  } catch (error) {
    setText(byId('trouble'), messageOf(error));
  }
}
