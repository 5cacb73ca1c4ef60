/** The drawing of a kind, for what is no component. */

import { h, render } from 'preact';
import { Drawing } from './drawing.tsx';
import type { Sketch } from '../../solver/types.ts';

export function sketch(of: Sketch) {
  const place = document.createElement('div');
  render(h(Drawing, { of }), place);
  return place.firstElementChild as SVGSVGElement;
}
