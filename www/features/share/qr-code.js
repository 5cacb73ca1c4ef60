/** A link as a code that a phone scans from the screen or from a printed sheet. */

import { encode } from 'uqr';

/** With more characters its squares are too small for a phone that looks at a screen. */
export const MOST_SCANNED = 1_000;
/** Squares that stay white around it, as its standard asks. */
const BORDER = 4;
const SPACE = 'http://www.w3.org/2000/svg';

/**
 * @param {string} text
 * @param {string} label
 */
export function qrCode(text, label) {
  const { data, size } = encode(text, { ecc: 'L', border: BORDER });
  const rows = data.map((row, y) =>
    row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : '')).join(''),
  );
  const svg = document.createElementNS(SPACE, 'svg');
  svg.setAttribute('class', 'qr-code');
  svg.setAttribute('viewBox', `0 0 ${size} ${size}`);
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', label);
  svg.setAttribute('shape-rendering', 'crispEdges');
  const path = document.createElementNS(SPACE, 'path');
  path.setAttribute('d', rows.join(''));
  svg.append(path);
  return svg;
}
