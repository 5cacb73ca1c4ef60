/** How to cite the paper and this program, as BibTeX. */

import './cite.css';
import { openDialog } from '../../ui/controls/dialog.ts';
import { element, setText } from '../../ui/dom.ts';
import { copyText } from '../../ui/copy-text.ts';

const PAPER = `@article{bouaziz2012shapeup,
  author  = {Bouaziz, Sofien and Deuss, Mario and Schwartzburg, Yuliy and Weise, Thibaut and Pauly, Mark},
  title   = {Shape-Up: Shaping Discrete Geometry with Projections},
  journal = {Computer Graphics Forum},
  volume  = {31},
  number  = {5},
  pages   = {1657--1667},
  year    = {2012},
  doi     = {10.1111/j.1467-8659.2012.03171.x},
  note    = {Proceedings of the Symposium on Geometry Processing}
}`;

/** @param address of the page */
const program = (address: string) => `@software{shapeup,
  author  = {{The Shape-Up authors}},
  title   = {Shape-Up: shaping discrete geometry with projections, in a browser tab},
  year    = {2026},
  url     = {${address}}
}`;

export function showCitation() {
  const address = new URL('./', location.href.split(/[?#]/)[0]).href;
  openDialog(
    { id: 'cite', title: 'Cite', light: true },
    element(
      'div.dialog-body',
      entry('The paper, for the method', PAPER),
      entry('This program, for numbers and pictures made with it', program(address)),
    ),
  );
}

function entry(title: string, text: string) {
  const said = element('span.quiet', { 'aria-live': 'polite' });
  const code = element('pre', { tabindex: '0', 'aria-label': `BibTeX: ${title}` }, text);
  const copy = async () => setText(said, await copyText(text));
  return element(
    'section',
    element('h3', title),
    code,
    element('p', element('button.bordered', { onclick: copy }, 'Copy'), said),
  );
}
