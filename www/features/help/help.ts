/** The help: all actions of keys and mouse, from the table that binds them, and how to cite. */

import './help.css';
import { keyName, singleKeys } from '../../ui/keys.ts';
import { dialogHead, openDialog } from '../../ui/controls/dialog.ts';
import { element, setText } from '../../ui/dom.ts';
import { copyText } from '../../ui/output.ts';
import { webgl2Card, webgpuCard, type GraphicsCard } from '../../viewport/graphics-card.ts';
import { MOUSE_WORDS } from '../../viewport/input/mouse.ts';
import type { Command } from '../../app/context.ts';
import type { State } from '../../store/state.ts';
import type { FileFormat } from '../../solver/types.ts';

/** Actions of the pointer; see `pointer.ts`. */
const pointer = (mouse: State['mouse']): [string, string][] => [
  ['Drag a handle', 'move it, parallel to the screen'],
  ['Drag an arrow', 'move the selected handles along it; a square: in its plane'],
  ['Drag elsewhere', 'orbit; with Select: a box, a lasso or a brush'],
  ['Box to the right', 'select what is inside'],
  ['Box to the left', 'select what it touches'],
  ['Click', 'select; Shift adds, Ctrl removes'],
  [
    'Double-click',
    'a vertex: make a handle; an edge: select its loop, with Shift its ring; a face: select its flat patch',
  ],
  ['Other buttons', `${MOUSE_WORDS[mouse]} (the menu Views has other settings)`],
  ['Right click', 'open the menu; so does a long press'],
  ['Wheel, pinch', 'zoom to the cursor'],
  ['Two fingers', 'pan and zoom'],
  ['Hold Reset', 'show the original as long as it is held'],
];
/** Keys of the view itself; see `gestures.ts`, `handle-keys.ts` and `pointer.ts`. */
const VIEW_KEYS: [string, string][] = [
  ['Arrows', 'orbit, while the view has the focus'],
  ['PgUp PgDn', 'zoom'],
  ['Enter', 'move the selected handles with the arrow keys; Enter accepts, Esc cancels'],
  ['X Y Z', 'while a handle is dragged: move along that axis'],
  ['Shift Ctrl', 'while a handle is dragged: Shift keeps its height, Ctrl moves it vertically'],
  ['Alt + drag', 'on a vertex: make it a handle and move it'],
];

type Renderer = State['renderer'];
const INTERFACES: {
  [name in Renderer]?: {
    label: string;
    cardOf: () => GraphicsCard | null | Promise<GraphicsCard | null>;
  };
} = {
  webgpu: { label: 'WebGPU', cardOf: webgpuCard },
  webgl2: { label: 'WebGL2', cardOf: webgl2Card },
};

/**
 * @param formats of files; without an engine there are none
 * @param renderer what draws the view
 * @param mouse what its buttons do
 * @param showAll shows all commands
 */
export function showHelp(
  dialog: HTMLDialogElement,
  commands: Command[],
  formats: Promise<FileFormat[]>,
  { renderer, mouse }: Pick<State, 'renderer' | 'mouse'>,
  showAll: () => void,
) {
  const drawn = element('p.about', { 'aria-live': 'polite' });
  void cardInWords(renderer).then((words) => setText(drawn, words));
  const files = element('section.files', { 'aria-live': 'polite' });
  formats.then((known) => files.replaceChildren(...filesTable(known))).catch(() => files.remove());
  const bound = commands.filter((command) => command.keys.length > 0);
  const groups = [...new Set(bound.map((command) => command.group))];
  dialog.replaceChildren(
    dialogHead(dialog, 'help-title', 'Mouse and keys'),
    element(
      'div.help-top',
      singleKeysSwitch(),
      element(
        'button.bordered',
        {
          'aria-haspopup': 'dialog',
          onclick: () => {
            dialog.close();
            showAll();
          },
        },
        'All commands',
        element('kbd', keyName('Ctrl+K')),
      ),
    ),
    element(
      'div.columns',
      section(
        'Mouse and touch',
        pointer(mouse).map(([what, effect]) => [[what], effect]),
      ),
      ...groups.map((group) =>
        section(group, [
          ...bound.filter((command) => command.group === group).map((command) => keysOf(command)),
          ...(group === 'View' ? VIEW_KEYS.map(([key, effect]) => keyRow([key], effect)) : []),
        ]),
      ),
    ),
    files,
    drawn,
    element(
      'p.about',
      'Everything is computed in this browser; nothing is uploaded. After “Shape-Up: Shaping Discrete Geometry with Projections”, Bouaziz, Deuss, Schwartzburg, Weise, Pauly, 2012. ',
      element('a', { href: './licences.html', target: '_blank' }, 'Licences'),
      ' ',
      element('button.bordered', { onclick: showCitation, 'aria-haspopup': 'dialog' }, 'Cite'),
    ),
  );
  dialog.onclick = (event) => {
    if (event.target === dialog) dialog.close();
  };
  dialog.showModal();
}

/** Says which interface of the browser draws, and with which graphics card. */
async function cardInWords(renderer: Renderer) {
  const { label, cardOf } = INTERFACES[renderer] ?? {};
  if (!cardOf) return '';
  const card = await cardOf();
  const how = card?.isSoftware ? ', without a graphics card: slow with large meshes' : '';
  return `Drawn by ${label}${card?.name ? ` with ${card.name}` : ''}${how}.`;
}

/** What is read and written of each format. */
function filesTable(formats: FileFormat[]) {
  const row = ({ name, endings, reads, writes, leaves_out }: FileFormat) =>
    element(
      'tr',
      element('th', { scope: 'row' }, name, ' ', element('span', `.${endings.join(' .')}`)),
      ...[reads, writes, leaves_out].map((words) => element('td', words || '–')),
    );
  const heads = ['Format', 'Read', 'Written', 'Not'].map((head) =>
    element('th', { scope: 'col' }, head),
  );
  return [
    element('h3', { id: 'files-title' }, 'Files'),
    element(
      'div',
      { tabindex: '0', role: 'region', 'aria-labelledby': 'files-title' },
      element(
        'table',
        { 'aria-labelledby': 'files-title' },
        element('thead', element('tr', ...heads)),
        element('tbody', ...formats.map(row)),
      ),
    ),
  ];
}

function keysOf({ keys, label }: Command): [(Node | string)[], string] {
  return keyRow(keys.map(keyName), label);
}

function keyRow(keys: string[], effect: string): [(Node | string)[], string] {
  return [keys.flatMap((key) => [element('kbd', key), ' ']), effect];
}

function section(title: string, rows: [(Node | string)[], string][]) {
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

/** The paper as BibTeX. */
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

/**
 * This program as BibTeX.
 * @param address of the page
 */
const program = (address: string) => `@software{shapeup,
  author  = {{The Shape-Up authors}},
  title   = {Shape-Up: shaping discrete geometry with projections, in a browser tab},
  year    = {2026},
  url     = {${address}}
}`;

/** Shows how to cite the paper and this program. */
function showCitation() {
  const address = new URL('./', location.href.split(/[?#]/)[0]).href;
  openDialog(
    { id: 'cite', title: 'Cite', light: true, lasts: true },
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
