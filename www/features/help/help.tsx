/** The help: all actions of keys and mouse, from the table that binds them, and how to cite. */

import './help.css';
import { useEffect, useState } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { pageAddress } from '../../documents/share-link.ts';
import { performNamed } from '../../store/perform.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { CTRL, keyName, singleKeys } from '../../ui/keys.ts';
import { copyText } from '../../ui/output.ts';
import { INTERFACES } from '../../viewport/graphics-card.ts';
import { MOUSE_WORDS } from '../../viewport/input/mouse.ts';
import { TERMS } from './terms.ts';
import type { AppContext } from '../../app/context.ts';
import type { State } from '../../store/state.ts';
import type { FileFormat } from '../../pkg/engine/shape_up.js';

/** Actions of the pointer; see `pointer.ts`. */
const pointer = (mouse: State['mouse']): [string, string][] => [
  ['Drag a handle', 'move it, parallel to the screen'],
  ['Drag an arrow', 'move the selected handles along it; a square: in its plane'],
  ['Drag elsewhere', 'orbit; with Select: a box, a lasso or a brush'],
  ['Box to the right', 'select what is inside'],
  ['Box to the left', 'select what it touches'],
  ['Click', `select; Shift adds, ${CTRL} removes; Alt selects the loop of an edge`],
  ['Shift drag', 'beside the model: move the view'],
  [
    'Double-click',
    'a vertex: make a handle; an edge: select its loop, on the boundary a second time all of it, with Shift its ring; a face: select its flat patch',
  ],
  ['Other buttons', `${MOUSE_WORDS[mouse]} (the menu Views has other settings)`],
  ['Right click', 'open the menu; so does a long press'],
  ['Wheel, pinch', 'zoom to the cursor; with Alt, the wheel changes the radius of the brush'],
  ['Two fingers', 'pan and zoom'],
  ['Hold Reset', 'show the original as long as it is held'],
  ['Type a number', '1.5, 1/3, 20 cm in a field of a length, +0.5 to add'],
];
/** Keys of the view itself; see `gestures.ts`, `handle-keys.ts` and `pointer.ts`. */
const VIEW_KEYS: [string, string][] = [
  ['Arrows', 'orbit, while the view has the focus'],
  ['PgUp PgDn', 'zoom'],
  ['Enter', 'move the selected handles with the arrow keys; Enter accepts, Esc cancels'],
  ['X Y Z', 'while a handle is dragged: move along that axis'],
  [
    `Shift ${CTRL}`,
    `while a handle is dragged: Shift keeps its height, ${CTRL} moves it vertically`,
  ],
  ['Alt + drag', 'on a vertex: make it a handle and move it'],
];

/** The version of this program, which the build of the page writes here. */
const VERSION: string = import.meta.env.VERSION;

/** What a constraint can require; see `details.tsx`. */
const REQUIRED: [string, string][] = [
  ['Soft', 'pulls, and gives way to whatever pulls the other way'],
  [
    'Within',
    'no vertex is farther from the shape than a length: enough to build, and the mesh usually moves less than for Exact',
  ],
  [
    'Exact',
    'satisfied exactly, by the mesh that is as close as possible to all that is soft; what cannot be satisfied together is named',
  ],
];

export function showHelp(app: AppContext) {
  showDialog(app, { id: 'help', title: 'Mouse and keys', light: true, lasts: true }, Help);
}

function Help({ close }: InDialog) {
  const app = useApp();
  const { renderer, mouse } = app.store.state;
  const bound = app.commands.filter((command) => command.keys.length > 0);
  const groups = [...new Set(bound.map((command) => command.group))];
  return (
    <>
      <div class="help-top">
        <label class="single-keys">
          <input
            type="checkbox"
            defaultChecked={singleKeys.on}
            onChange={({ currentTarget }) => singleKeys.set(currentTarget.checked)}
          />
          <span>Enable single-key shortcuts</span>
        </label>
        <Button
          aria-haspopup="dialog"
          onClick={() => {
            close();
            performNamed('palette', app);
          }}
        >
          All commands
          <kbd>{keyName('Ctrl+K')}</kbd>
        </Button>
      </div>
      <div class="columns">
        <Keys title="Mouse and touch">
          {pointer(mouse).map(([what, effect]) => (
            <Row key={what} term={what} effect={effect} />
          ))}
        </Keys>
        <Keys title="What a constraint requires">
          {REQUIRED.map(([what, effect]) => (
            <Row key={what} term={what} effect={effect} />
          ))}
        </Keys>
        <Keys title="Words">
          {TERMS.map(([what, meaning]) => (
            <Row key={what} term={what} effect={meaning} />
          ))}
        </Keys>
        {groups.map((group) => (
          <Keys key={group} title={group}>
            {bound
              .filter((command) => command.group === group)
              .map(({ id, keys, label }) => (
                <Row key={id} term={asKeys(keys.map(keyName))} effect={label} />
              ))}
            {group === 'View' &&
              VIEW_KEYS.map(([key, effect]) => (
                <Row key={key} term={asKeys([key])} effect={effect} />
              ))}
          </Keys>
        ))}
      </div>
      <FileFormats />
      <DrawnBy renderer={renderer} />
      <p class="about">
        Version {VERSION}. Everything is computed in this browser; nothing is uploaded. After
        “Shape-Up: Shaping Discrete Geometry with Projections”, Bouaziz, Deuss, Schwartzburg, Weise,
        Pauly, 2012.{' '}
        <a href="./licences.html" target="_blank">
          Licences
        </a>
        {' · '}
        <a href="./checked.html" target="_blank">
          What is checked
        </a>
        {' · '}
        <a href="./speed.html" target="_blank">
          How fast it is
        </a>
        {' · '}
        <a href="./rhino.html" target="_blank">
          Rhino and Grasshopper
        </a>
        {' · '}
        <a href="./teaching.html" target="_blank">
          For teachers
        </a>{' '}
        <Button aria-haspopup="dialog" onClick={() => showCitation(app)}>
          Cite
        </Button>
      </p>
    </>
  );
}

/** A list of keys, of what the pointer does, or of words. */
const Keys = ({ title, children }: { title: string; children: ComponentChildren }) => (
  <section>
    <h3>{title}</h3>
    <dl>{children}</dl>
  </section>
);

const Row = ({ term, effect }: { term: ComponentChildren; effect: string }) => (
  <>
    <dt>{term}</dt>
    <dd>{effect}</dd>
  </>
);

const asKeys = (keys: string[]) => keys.map((key) => [<kbd key={key}>{key}</kbd>, ' ']);

/** What is read and written of each format; nothing without an engine, which knows them. */
function FileFormats() {
  const { actions } = useApp();
  const [formats, setFormats] = useState<FileFormat[]>([]);
  useEffect(() => {
    actions.ask.fileFormats().then(setFormats, () => {});
  }, []);
  return (
    <section class="files" aria-live="polite" hidden={formats.length === 0}>
      <h3 id="files-title">Files</h3>
      <div tabindex={0} role="region" aria-labelledby="files-title">
        <table aria-labelledby="files-title">
          <thead>
            <tr>
              {['Format', 'Read', 'Written', 'Left out'].map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {formats.map(({ name, endings, reads, writes, leaves_out }) => (
              <tr key={name}>
                <th scope="row">
                  {name} <span>{`.${endings.join(' .')}`}</span>
                </th>
                <td>{reads || '–'}</td>
                <td>{writes || '–'}</td>
                <td>{leaves_out || '–'}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}

/** Says which interface of the browser draws, and with which graphics card. */
function DrawnBy({ renderer }: Pick<State, 'renderer'>) {
  const [words, setWords] = useState('');
  useEffect(() => {
    const { label, cardOf } = INTERFACES[renderer] ?? {};
    void Promise.resolve(cardOf?.()).then((card) => {
      const how = card?.isSoftware ? ', without a graphics card: slow with large meshes' : '';
      setWords(label ? `Drawn by ${label}${card?.name ? ` with ${card.name}` : ''}${how}.` : '');
    });
  }, [renderer]);
  return (
    <p class="about" aria-live="polite">
      {words}
    </p>
  );
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
  version = {${VERSION}},
  url     = {${address}}
}`;

/** Shows how to cite the paper and this program. */
function showCitation(app: AppContext) {
  const address = pageAddress();
  showDialog(app, { id: 'cite', title: 'Cite', light: true, lasts: true }, () => (
    <div class="dialog-body">
      <BibTeX title="The paper, for the method" text={PAPER} />
      <BibTeX title="This program, for numbers and pictures made with it" text={program(address)} />
    </div>
  ));
}

function BibTeX({ title, text }: { title: string; text: string }) {
  const [said, setSaid] = useState('');
  return (
    <section>
      <h3>{title}</h3>
      <pre tabindex={0} aria-label={`BibTeX: ${title}`}>
        {text}
      </pre>
      <p>
        <Button onClick={async () => setSaid(await copyText(text))}>Copy</Button>
        <span class="quiet" aria-live="polite">
          {said}
        </span>
      </p>
    </section>
  );
}
