/** A picture of the view as PNG, larger than the screen if wanted, with the legend drawn into it. */

import { length, lengthUnit } from './format.js';
import { MEASURES } from './measures.js';

/** More pixels than this are too many for common graphics cards, with their samples and depths. */
const MOST_PIXELS = 36e6;
const STOPS = 24;

/**
 * The size of the picture, in pixels.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {number} scale pixels per CSS pixel
 */
export function pictureSize(viewport, scale) {
  const { width, height } = viewport.element.getBoundingClientRect();
  const most = Math.sqrt(MOST_PIXELS / Math.max(width * height, 1));
  const used = Math.min(scale, most);
  return { width: Math.round(width * used), height: Math.round(height * used), scale: used };
}

/**
 * @param {import("./viewport.js").Viewport} viewport
 * @param {import("./state.js").State} state
 * @param {{ scale: number, legend: boolean, white: boolean }} options
 * @returns {Promise<Blob>}
 */
export async function pictureOf(viewport, state, { scale, legend, white }) {
  const size = pictureSize(viewport, scale);
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [size.width, size.height];
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser gives the page no canvas to draw the picture on.');
  const drawn = viewport.still(size, white, (view) => {
    context.drawImage(view, 0, 0, size.width, size.height);
  });
  if (!drawn) throw new Error('The picture could not be drawn: try a smaller one.');
  if (legend && state.measure && state.model?.faces) {
    const stops = viewport.with((view) => view.colourStops(STOPS)) ?? [];
    drawLegend(context, state, stops, size, white);
  }
  const blob = await new Promise((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('The picture is too large for this browser: try a smaller one.');
  return blob;
}

/**
 * The legend at the lower left, in the sizes of the page.
 * @param {CanvasRenderingContext2D} context
 * @param {import("./state.js").State} state
 * @param {string[]} stops
 * @param {{ height: number, scale: number }} size
 * @param {boolean} white
 */
function drawLegend(context, { measure, range, document: scene, dark }, stops, size, white) {
  if (!measure) return;
  const units = scene?.units ?? '';
  const [left, width, bottom] = [16, 212, size.height / size.scale - 16];
  context.scale(size.scale, size.scale);
  context.font = `12px ${getComputedStyle(document.body).fontFamily}`;
  context.fillStyle = dark && !white ? '#e6e8e8' : '#1d2123';
  context.textBaseline = 'alphabetic';
  context.fillText(MEASURES[measure].label, left, bottom - 32);
  context.fillText(`0 ${lengthUnit(range[1], units).unit}`.trim(), left, bottom);
  context.textAlign = 'right';
  context.fillText(length(range[1], units), left + width, bottom);
  const ramp = context.createLinearGradient(left, 0, left + width, 0);
  stops.forEach((colour, i) => ramp.addColorStop(i / (stops.length - 1), colour));
  context.fillStyle = ramp;
  context.fillRect(left, bottom - 26, width, 10);
}
