/**
 * The Share dialog: the link with its length and where a link of that length works, the link as a
 * QR code, and the line of HTML that embeds the model in another page.
 */

import './share.css';
import { useEffect, useState } from 'preact/hooks';
import { encode } from 'uqr';
import { linkTo } from '../../documents/share-link.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { groupDigits, limit } from '../../ui/words.ts';
import { copyText } from '../../ui/output.ts';
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
  const { address, rounded } = await linkTo(app);
  showDialog(app, { id: 'share', title: 'Share' }, ({ close }) => (
    <Share close={close} link={address} rounded={rounded} />
  ));
}

/** @param props.rounded the rounding step of the positions in the link, if they are rounded */
function Share({ close, link, rounded }: InDialog & { link: string; rounded: number | null }) {
  const { store, files } = useApp();
  const { example, fileName, document: scene } = store.state;
  const [said, setSaid] = useState('');
  const found = LEVELS.find(({ most }) => link.length <= most);
  const characters = groupDigits(link.length);
  const line = frameLine(link, example?.title ?? fileName);

  /** @param refused message if the browser refuses to copy */
  const copy = async (text: string, refused?: string) => setSaid(await copyText(text, refused));
  useEffect(() => {
    // Some browsers allow copying only on a user action; the button still works there.
    if (found) void copy(link, '');
  }, []);

  return (
    <div class="dialog-body">
      <p>
        Whoever opens this link gets the mesh with its constraints and handles; if you have run it,
        their browser runs it again. Nothing is uploaded.
      </p>
      {found && (
        <textarea
          autofocus
          readOnly
          rows={3}
          aria-label="Link"
          spellcheck={false}
          value={link}
          onFocus={({ currentTarget }) => {
            currentTarget.select();
            // The beginning identifies the link.
            currentTarget.scrollTop = 0;
          }}
        />
      )}
      <meter
        aria-label="Length of the link"
        min={0}
        max={9_000}
        low={2_000}
        high={8_000}
        optimum={0}
        value={Math.min(link.length, 9_000)}
      />
      <p class={`length ${found?.level ?? 'poor'}`}>
        {found
          ? `${characters} characters. ${found.words}`
          : `${characters} characters are more than a link can have. Save the scene and send the file.`}
      </p>
      {rounded !== null && (
        <p class="quiet">
          {`To keep the link short, positions are rounded to ${limit(rounded, scene?.units ?? '')}, at most a hundredth of the tolerance. A scene file is exact.`}
        </p>
      )}
      <p class="quiet" aria-live="polite" id="share-copied">
        {said}
      </p>
      {found && (
        <div class="share-others">
          {link.length <= MOST_SCANNED ? (
            <QrCode text={link} label="QR code of the link" />
          ) : (
            <p class="quiet no-code">The link is too long for a QR code: save the scene instead.</p>
          )}
          <div class="embed">
            <label for="share-line">To embed it in your own web page</label>
            <input id="share-line" readOnly spellcheck={false} value={line} />
            <p class="quiet">
              A live model that loads when somebody starts it, and stores nothing. With “&autoplay”
              after “?embed” it starts and runs at once.
            </p>
            <Button onClick={() => copy(line)}>Copy line</Button>
          </div>
        </div>
      )}
      <div class="dialog-buttons">
        {found && (
          <Button class="primary" onClick={() => copy(link)}>
            Copy link
          </Button>
        )}
        <Button
          onClick={() => {
            close();
            void files.saveScene();
          }}
        >
          Save scene instead
        </Button>
      </div>
    </div>
  );
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
  const source = escaped(link.replace('#', 'embed.html?embed#'));
  return `<iframe src="${source}" title="${escaped(title)}, in Shape-Up" width="720" height="480" loading="lazy" style="border: 0"></iframe>`;
}

const escaped = (text: string) => text.replaceAll(/[&"<]/g, (character) => ESCAPES[character]);

/** Maximum number of characters of a QR code: with more, the modules are too small to scan from a screen. */
const MOST_SCANNED = 1_000;
/** Width of the quiet zone in modules, as the QR standard requires. */
const BORDER = 4;

/** A link as a QR code, to scan from the screen or from paper. */
function QrCode({ text, label }: { text: string; label: string }) {
  const { data, size } = encode(text, { ecc: 'L', border: BORDER });
  const dark = data.flatMap((row, y) =>
    row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : '')),
  );
  return (
    <svg
      class="qr-code"
      role="img"
      aria-label={label}
      viewBox={`0 0 ${size} ${size}`}
      shape-rendering="crispEdges"
    >
      <path d={dark.join('')} />
    </svg>
  );
}
