/** Note on the open example: its figure, what to look for, and links to its neighbours. */

import { element } from '../ui/dom.ts';
import { linkToExample } from '../documents/examples.ts';
import type { Example } from '../solver/examples.ts';
import type { AppContext } from '../app/context.ts';

/** @param place a section, hidden while no example is open */
export function exampleNote(
  place: HTMLElement,
  { files, actions }: AppContext,
  show: (plot: string) => void,
) {
  const link = (text: string, to: Example | undefined) => {
    if (!to) return [];
    const onclick = (event: Event) => {
      // A link to the current address would do nothing.
      const link = linkToExample(to.id);
      if (location.hash !== link) return;
      event.preventDefault();
      void actions.reportErrors(files.openExample(to, { link }));
    };
    return [element('a', { href: linkToExample(to.id), title: to.title, onclick }, text)];
  };

  async function showNote() {
    const { example } = files.origin;
    place.hidden = !example;
    if (!example) return;
    const { figure, summary, statement, plots } = example;
    const all = await files.examples();
    const at = all.findIndex(({ id }) => id === example.id);
    const title = figure === null ? 'Example' : `Figure ${figure} of the paper`;
    place.replaceChildren(
      element('h2', { id: 'heading-example' }, title),
      element('p', summary),
      element('p.quiet', 'Once solved: ', statement),
      ...plots.map(({ label, plot }) =>
        element('button.bordered.small', { onclick: () => show(plot) }, label),
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
  void showNote();
}
