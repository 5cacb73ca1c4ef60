/** Note on the open example: its figure, what to look for, and links to its neighbours. */

import { element } from '../../ui/dom.js';
import { linkTo } from '../../documents/example-links.js';
import { withSymbols } from '../../ui/symbols.js';

/** @typedef {import("../../solver/examples.js").Example} Example */

/**
 * @param {HTMLElement} place a section, hidden while no example is open
 * @param {import("../../app/context.js").AppContext} app
 * @param {(shows: import("../../solver/examples.js").Suggestion["shows"]) => void} show
 */
export function exampleNote(place, { files, actions }, show) {
  /** @param {string} text @param {Example | undefined} to */
  const link = (text, to) => {
    if (!to) return [];
    /** @param {Event} event */
    const onclick = (event) => {
      // A link to the current address would do nothing.
      if (location.hash !== linkTo(to.id)) return;
      event.preventDefault();
      actions.reportErrors(files.openExample(to));
    };
    return [element('a', { href: linkTo(to.id), title: to.title, onclick }, text)];
  };

  async function showNote() {
    const { example } = files.origin;
    place.hidden = !example;
    if (!example) return;
    const { figure, summary, statement, suggestions } = example;
    const all = await files.examples();
    const at = all.findIndex(({ id }) => id === example.id);
    const title = figure === null ? 'Example' : `Figure ${figure} of the paper`;
    place.replaceChildren(
      element('h2', { id: 'heading-example' }, title),
      element('p', summary),
      element('p.quiet', 'Once solved: ', ...withSymbols(statement)),
      ...suggestions.map(({ label, shows }) =>
        element('button.bordered.small', { onclick: () => show(shows) }, ...withSymbols(label)),
      ),
      element(
        'nav.beside',
        { 'aria-label': 'Examples one by one' },
        ...link('Previous', all[at - 1]),
        element('a', { href: './gallery.html' }, 'Gallery'),
        ...link('Next', all[at + 1]),
      ),
    );
  }
  files.on('opened', showNote);
  showNote();
}
