/** The view as a PNG picture, optionally larger than the screen, with the legend drawn into it. */

import { rampStops } from '../../viewport/ramp.ts';
import { colourOf } from '../../ui/dom.ts';
import { groupDigits, measured } from '../../ui/words.ts';
import { inLegend, toleranceOf } from '../../store/colours/measures.ts';
import type { Label, Viewport } from '../../viewport/viewport.ts';
import type { State } from '../../store/state.ts';

/** The background; transparent for `none`. */
export type Ground = 'view' | 'white' | 'none';

/** Maximum of the longer side and of the pixel count, set by the memory of common browsers. */
const [LONGEST, MOST_PIXELS] = [7680, 60e6];

/**
 * The size of the picture, in pixels.
 * @param scale pixels per CSS pixel; infinite for the maximum
 */
export function pictureSize(viewport: Viewport, scale: number) {
  const { width, height } = viewport.element.getBoundingClientRect();
  const most = Math.sqrt(MOST_PIXELS / Math.max(width * height, 1));
  const used = Math.min(scale, most, LONGEST / Math.max(width, height, 1));
  return { width: Math.round(width * used), height: Math.round(height * used), scale: used };
}

export async function pictureOf(
  viewport: Viewport,
  state: State,
  { scale, legend, ground }: { scale: number; legend: boolean; ground: Ground },
): Promise<Blob> {
  const size = pictureSize(viewport, scale);
  const drawnOn = (grey: number | undefined) => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [size.width, size.height];
    const context = canvas.getContext('2d', { willReadFrequently: ground === 'none' });
    if (!context)
      throw new Error('This browser gave the page no canvas for the picture: try a smaller one.');
    const drawn = viewport.still(size, grey, (tile, left, top) => {
      context.drawImage(tile, left, top);
    });
    if (!drawn) throw new Error('The picture could not be drawn: try a smaller one.');
    return context;
  };
  const context = drawnOn({ view: undefined, white: 1, none: 0 }[ground]);
  if (ground === 'none') cutOut(context, drawnOn(1));
  const { canvas } = context;
  const onLight = ground !== 'view';
  if (legend) {
    context.setTransform(size.scale, 0, 0, size.scale, 0, 0);
    drawLegend(context, state, rampStops(viewport), size, onLight);
  }
  drawLabels(context, viewport.labels(), size.scale, state.dark && !onLight);
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('The picture is too large for this browser: try a smaller one.');
  return blob;
}

/** Draws the labels, each on a background that sets it off from the picture. */
function drawLabels(
  context: CanvasRenderingContext2D,
  labels: Label[],
  scale: number,
  dark: boolean,
) {
  const [ink, ground] = dark ? ['#e6e8e8', '#25292c'] : ['#1d2123', '#ffffff'];
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.font = `12px ${getComputedStyle(document.body).fontFamily}`;
  for (const { text, x, y, align, bar } of labels) {
    const { width } = context.measureText(text);
    const left = align === 'center' ? x - width / 2 : x - width;
    context.fillStyle = ground;
    if (align === 'center') context.fillRect(left - 5, y - 13, width + 10, 18);
    context.fillStyle = ink;
    context.textAlign = 'left';
    context.fillText(text, left, bar > 0 ? y - 8 : y);
    if (bar === 0) continue;
    context.fillRect(x - bar, y - 1.5, bar, 1.5);
    for (const end of [x - bar, x - 1.5]) context.fillRect(end, y - 5, 1.5, 5);
  }
}

/** Draws the legend at the lower left, in the page's sizes: the histogram above the colour ramp. */
function drawLegend(
  context: CanvasRenderingContext2D,
  state: State,
  stops: [number, string][],
  size: { height: number; scale: number },
  onLight: boolean,
) {
  const { spread, document: scene, dark, display } = state;
  const about = inLegend(state);
  if (!about || !spread || spread.measure !== about.id) return;
  const tolerance = toleranceOf(state, about);
  const { axis, places } = spread;
  const units = scene?.units ?? '';
  const words = (value: number) => measured(value, about.unit, units, tolerance);
  const bottom = size.height / size.scale - (tolerance === null ? 16 : 28);
  const [left, width] = [16, 212];
  const ink = dark && !onLight ? '#e6e8e8' : '#1d2123';
  const [foot, tallest] = [bottom - 26, 28];
  context.textAlign = 'left';
  context.font = `12px ${getComputedStyle(document.body).fontFamily}`;
  context.fillStyle = ink;
  context.fillText(about.label, left, foot - tallest - 8);
  context.fillText(axis.low === 0 ? '0' : words(axis.low), left, bottom);
  context.textAlign = 'right';
  context.fillText(words(axis.high), left + width, bottom);

  const most = Math.max(...spread.counts, 1);
  const bar = width / spread.counts.length;
  spread.counts.forEach((count, i) => {
    const height = count > 0 ? Math.max(2, (tallest * count) / most) : 0;
    context.fillRect(left + i * bar, foot - height, bar - 1, height);
  });
  const ramp = context.createLinearGradient(left, 0, left + width, 0);
  const { low, high } = places;
  for (const [at, colour] of stops) ramp.addColorStop(low + (high - low) * at, colour);
  context.fillStyle = ramp;
  context.fillRect(left, foot, width, 10);
  if (tolerance === null || places.tolerance === null) return;
  const limit = left + places.tolerance * width;
  if (!display.full) {
    context.fillStyle = onLight ? '#f1efea' : colourOf(document.body, '--material');
    context.fillRect(left, foot, limit - left, 10);
  }
  context.fillStyle = ink;
  const within = `${groupDigits(spread.within)} of ${groupDigits(spread.faces)} within ${words(tolerance)}`;
  context.textAlign = 'center';
  context.fillText(within, left + width / 2, bottom + 14);
  if (tolerance <= axis.high) context.fillRect(limit - 1, foot - tallest, 2, tallest + 10);
}

/** Rows read at once, to limit the memory for a large picture. */
const ROWS = 256;

/**
 * Makes a picture with transparency from the same picture on white and on black. A colour `c` with
 * coverage `a` gives `a c + 1 - a` on white and `a c` on black, so their difference is the transparency
 * `1 - a`. Writes the result to `onBlack`.
 */
function cutOut(onBlack: CanvasRenderingContext2D, onWhite: CanvasRenderingContext2D) {
  const { width, height } = onBlack.canvas;
  for (let top = 0; top < height; top += ROWS) {
    const rows = Math.min(ROWS, height - top);
    const picture = onBlack.getImageData(0, top, width, rows);
    const black = picture.data;
    const white = onWhite.getImageData(0, top, width, rows).data;
    for (let at = 0; at < black.length; at += 4) {
      const whiteSum = white[at] + white[at + 1] + white[at + 2];
      const blackSum = black[at] + black[at + 1] + black[at + 2];
      const covered = Math.min(Math.max(1 - (whiteSum - blackSum) / 765, 0), 1);
      for (let i = at; i < at + 3; i++) black[i] = covered > 0 ? black[i] / covered : 0;
      black[at + 3] = Math.round(255 * covered);
    }
    onBlack.putImageData(picture, 0, top);
  }
}
