/** What to look for in the example that is open, and the ways to the ones beside it. */

import { element } from '../dom.js';
import { linkTo } from '../example-links.js';
import { withSymbols } from '../symbols.js';

/**
 * @param {HTMLElement} place a section, which is hidden while no example is open
 * @param {import("../state.js").Store} store
 */
export function exampleNote(place, store) {
  store.subscribe(['example'], ({ example }) => {
    place.hidden = example === null;
    if (!example) return;
    const { figure, summary, statement, beside } = example;
    const title = figure === null ? 'Example' : `Figure ${figure} of the paper`;
    const link = (/** @type {string} */ text, /** @type {{ id: string, title: string }} */ to) =>
      element('a', { href: linkTo(to.id), title: to.title }, text);
    place.replaceChildren(
      element('h2', { id: 'heading-example' }, title),
      element('p', {}, summary),
      element('p', { class: 'quiet' }, 'Solved: ', ...withSymbols(statement)),
      element(
        'nav',
        { 'aria-label': 'Examples one by one', class: 'beside' },
        ...(beside.previous ? [link('Previous', beside.previous)] : []),
        element('a', { href: './gallery.html' }, 'Gallery'),
        ...(beside.next ? [link('Next', beside.next)] : []),
      ),
    );
  });
}
