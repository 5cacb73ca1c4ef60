/**
 * The Share dialog: the link with its length and where a link of that length works, the link as a
 * QR code, and the line of HTML that embeds the model in another page.
 */

import './share.css';
import { encode } from 'uqr';
import { linkTo } from '../../documents/share-link.ts';
import { openDialog } from '../../ui/controls/dialog.ts';
import { element, setText } from '../../ui/dom.ts';
import { groupDigits, limit } from '../../ui/format.ts';
import { copyText } from '../../ui/output.ts';
import { svgElement } from '../../ui/svg.ts';
import type { AppContext } from '../../app/context.ts';

/** Maximum lengths of a link, in characters, with advice for links up to each length. */
const LEVELS = [
  { most: 2_000, level: 'good', words: 'Short enough for browsers, e-mail and chat programs.' },
  {
    most: 8_000,
    level: 'fair',
    words: 'Fine in browsers and most e-mail; some chat programs cut links of this length.',
  },
  {
    most: 80_000,
    level: 'poor',
    words:
      'Browsers open it, but chat programs and many e-mail programs will cut it. A scene file is safer.',
  },
  {
    most: 1_000_000,
    level: 'poor',
    words: 'Too long for some browsers and for all chat programs. Send the scene file instead.',
  },
];

export async function share(app: AppContext) {
  const { files, actions } = app;
  const { address: link, rounded } = await linkTo(app);
  const { example, fileName, document: scene } = app.store.get();
  const title = example?.title ?? fileName;
  const found = LEVELS.find(({ most }) => link.length <= most);
  const loss =
    rounded === null
      ? ''
      : `To keep the link short, positions are rounded to ${limit(rounded, scene?.units ?? '')}, at most a hundredth of the tolerance. A scene file is exact.`;
  const dialog = open({ link, found, title, loss }, () => {
    dialog.close();
    void files.saveScene();
  });
  const field = dialog.querySelector('textarea');
  field?.focus();
  field?.select();
  // The beginning identifies the link.
  if (field) field.scrollTop = 0;
  // Some browsers allow copying only on a user action; the button still works there.
  if (found) void actions.reportErrors(copy(link, dialog, ''));
}

/**
 * @param what.title of the model
 * @param what.loss note on rounding, if any
 */
function open(
  {
    link,
    found,
    title,
    loss,
  }: {
    link: string;
    found: { level: string; words: string } | undefined;
    title: string;
    loss: string;
  },
  save: () => void,
) {
  const characters = groupDigits(link.length);
  const words = found
    ? `${characters} characters. ${found.words}`
    : `${characters} characters are more than a link can have. Save the scene and send the file.`;
  const dialog = openDialog(
    { id: 'share', title: 'Share' },
    element(
      'div.dialog-body',
      element(
        'p',
        'Whoever opens this link gets the mesh with its constraints and handles, and their browser solves it again. The link contains everything: nothing is uploaded.',
      ),
      found
        ? element('textarea', {
            readonly: true,
            rows: 3,
            'aria-label': 'Link',
            spellcheck: 'false',
          })
        : '',
      element('meter', {
        'aria-label': 'Length of the link',
        min: 0,
        max: 9_000,
        low: 2_000,
        high: 8_000,
        optimum: 0,
        value: Math.min(link.length, 9_000),
      }),
      element('p', { class: `length ${found?.level ?? 'poor'}` }, words),
      loss && element('p.quiet', loss),
      element('p.quiet', { 'aria-live': 'polite', id: 'share-copied' }),
      found ? others(link, title) : '',
      element(
        'div.dialog-buttons',
        found ? element('button.primary', { onclick: () => copy(link, dialog) }, 'Copy link') : '',
        element('button.bordered', { onclick: save }, 'Save scene instead'),
      ),
    ),
  );
  const field = dialog.querySelector('textarea');
  if (field) field.value = link;
  return dialog;
}

/** The QR code, and the line of HTML for another page. */
function others(link: string, title: string) {
  const value = frameLine(link, title);
  const line = element('input', { id: 'share-line', readonly: true, spellcheck: 'false', value });
  const copyLine = () => {
    const dialog = line.closest('dialog');
    if (dialog) void copy(value, dialog);
  };
  return element(
    'div.share-others',
    link.length <= MOST_SCANNED
      ? qrCode(link, 'QR code of the link')
      : element('p.quiet.no-code', 'The link is too long for a QR code: save the scene instead.'),
    element(
      'div.embed',
      element('label', { for: 'share-line' }, 'To embed it in your own web page'),
      line,
      element(
        'p.quiet',
        'A live model that loads when somebody starts it, and stores nothing. With “&autoplay” after “?embed” it starts and runs at once.',
      ),
      element('button.bordered', { onclick: copyLine }, 'Copy line'),
    ),
  );
}

/** @param refused message if the browser refuses to copy */
async function copy(link: string, dialog: HTMLDialogElement, refused?: string) {
  const place = dialog.querySelector('#share-copied');
  const said = await copyText(link, refused);
  if (place) setText(place, said);
}

/** Escapes in a quoted HTML attribute. */
const ESCAPES = {
  '&': '&amp;',
  '"': '&quot;',
  '<': '&lt;',
} as Record<string, string>;

/**
 * The line of HTML that embeds a model in another page.
 * @param link to the scene
 * @param title of the model
 */
function frameLine(link: string, title: string) {
  const address = new URL(link);
  address.pathname = address.pathname.replace(/[^/]*$/, 'embed.html');
  const [plain, hash] = address.href.split('#');
  const source = escaped(`${plain.split('?')[0]}?embed#${hash}`);
  return `<iframe src="${source}" title="${escaped(title)}, in Shape-Up" width="720" height="480" loading="lazy" style="border: 0"></iframe>`;
}

const escaped = (text: string) => text.replaceAll(/[&"<]/g, (character) => ESCAPES[character]);

/** Maximum number of characters of a QR code: with more, the modules are too small to scan from a screen. */
const MOST_SCANNED = 1_000;
/** Width of the quiet zone in modules, as the QR standard requires. */
const BORDER = 4;

/** A link as a QR code, to scan from the screen or from paper. */
function qrCode(text: string, label: string) {
  const { data, size } = encode(text, { ecc: 'L', border: BORDER });
  const rows = data.map((row, y) =>
    row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : '')).join(''),
  );
  const attributes = {
    ...{ class: 'qr-code', role: 'img', 'aria-label': label },
    ...{ viewBox: `0 0 ${size} ${size}`, 'shape-rendering': 'crispEdges' },
  };
  return svgElement('svg', attributes, svgElement('path', { d: rows.join('') }));
}
