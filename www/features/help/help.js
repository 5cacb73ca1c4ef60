/** The help: all actions of keys and mouse, from the table that binds them. */

import './help.css';
import { keyName } from '../../ui/keys.js';
import { dialogHead } from '../../ui/controls/dialog.js';
import { element } from '../../ui/dom.js';
import { singleKeys } from '../../ui/single-keys.js';

/** Actions of the pointer; see `pointer.js`. @type {[string, string][]} */
const POINTER = [
  ['Drag a handle', 'move it, parallel to the screen'],
  ['Drag an arrow', 'move the selected handles along it; a square: in its plane'],
  ['Drag elsewhere', 'orbit; with Select: a box, a lasso or a brush'],
  ['Box to the right', 'select what is inside'],
  ['Box to the left', 'select what it touches'],
  ['Click', 'select; Shift adds, Ctrl removes'],
  [
    'Double-click',
    'a vertex: make a handle; an edge: select its loop; a face: select its flat patch',
  ],
  ['Right drag', 'orbit; a right click or a long press opens the menu'],
  ['Middle drag', 'pan; so does Shift + right drag'],
  ['Wheel, pinch', 'zoom to the cursor'],
  ['Two fingers', 'pan and zoom'],
  ['Hold Reset', 'show the original as long as it is held'],
];
/** Keys of the view itself; see `view-keys.js`, `handle-keys.js` and `pointer.js`. @type {[string, string][]} */
const VIEW_KEYS = [
  ['Arrows', 'orbit, while the view has the focus'],
  ['PgUp PgDn', 'zoom'],
  ['Enter', 'move the selected handles with the arrow keys; Enter accepts, Esc cancels'],
  ['X Y Z', 'while a handle is dragged: move along that axis'],
  ['Shift Ctrl', 'while a handle is dragged: Shift keeps its height, Ctrl moves it vertically'],
  ['Alt + drag', 'on a vertex: make it a handle and move it'],
];

/**
 * @param {HTMLDialogElement} dialog
 * @param {import("../../app/context.js").Command[]} commands
 */
export function showHelp(dialog, commands) {
  const bound = commands.filter((command) => command.keys.length > 0);
  const groups = [...new Set(bound.map((command) => command.group))];
  dialog.replaceChildren(
    dialogHead(dialog, 'help-title', 'Mouse and keys'),
    singleKeysSwitch(),
    element(
      'div.columns',
      section(
        'Mouse and touch',
        POINTER.map(([what, effect]) => [[what], effect]),
      ),
      ...groups.map((group) =>
        section(group, [
          ...bound.filter((command) => command.group === group).map((command) => keysOf(command)),
          ...(group === 'View' ? VIEW_KEYS.map(([key, effect]) => keyRow([key], effect)) : []),
        ]),
      ),
    ),
    element(
      'p.about',
      'Everything is computed in this browser; nothing is uploaded. After “Shape-Up: Shaping Discrete Geometry with Projections”, Bouaziz, Deuss, Schwartzburg, Weise, Pauly, 2012. ',
      element('a', { href: './licences.html', target: '_blank' }, 'Licences'),
      ' ',
      element('button.bordered', { onclick: cite, 'aria-haspopup': 'dialog' }, 'Cite'),
    ),
  );
  dialog.onclick = (event) => {
    if (event.target === dialog) dialog.close();
  };
  dialog.showModal();
}

const cite = () => import('./cite.js').then((it) => it.showCitation());

/** @param {import("../../app/context.js").Command} command @returns {[(Node | string)[], string]} */
function keysOf({ keys, label }) {
  return keyRow(keys.map(keyName), label);
}

/**
 * @param {string[]} keys
 * @param {string} effect
 * @returns {[(Node | string)[], string]}
 */
function keyRow(keys, effect) {
  return [keys.flatMap((key) => [element('kbd', key), ' ']), effect];
}

/**
 * @param {string} title
 * @param {[(Node | string)[], string][]} rows
 */
function section(title, rows) {
  return element(
    'section',
    element('h3', title),
    element(
      'dl',
      ...rows.flatMap(([term, effect]) => [element('dt', ...term), element('dd', effect)]),
    ),
  );
}

/** The switch for shortcuts without Ctrl. */
function singleKeysSwitch() {
  const onchange = () => singleKeys.set(box.checked);
  const box = element('input', { type: 'checkbox', checked: singleKeys.on, onchange });
  const words = element('span', 'Enable single-key shortcuts');
  return element('label.single-keys', box, words);
}
