/** A link as a QR code, to scan from the screen or from paper. */

import { encode } from 'uqr';
import { svgElement } from '../../ui/svg.ts';

/** Maximum number of characters: with more, the modules are too small to scan from a screen. */
export const MOST_SCANNED = 1_000;
/** Width of the quiet zone in modules, as the QR standard requires. */
const BORDER = 4;

export function qrCode(text: string, label: string) {
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
