/** A link as a QR code, to scan from the screen or from paper. */

import { encode } from 'uqr';

/** Maximum number of characters: with more, the modules are too small to scan from a screen. */
export const MOST_SCANNED = 1_000;
/** Width of the quiet zone in modules, as the QR standard requires. */
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
