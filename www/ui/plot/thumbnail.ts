/**
 * Thumbnails of shapes: faces from far to near, shaded, and coloured by displacement. What has one corner
 * is a dot, and what has two a line.
 */

import { colourOf } from '../dom.ts';
import type { Connectivity } from '../../solver/types.ts';

/** Canvas pixels per CSS pixel. */
const DENSITY = 2;
/** The width of seams and of lines, and the radius of dots, in canvas pixels. */
const [SEAM, LINE, DOT] = [DENSITY / 4, 1.5 * DENSITY, 2 * DENSITY];
/** The fraction of the picture that the shape fills. */
const FILLED = 0.92;
/** The default view direction: rotation about the vertical axis, then elevation, in radians. */
const FROM = { turn: 0.6, above: 0.5 };

/**
 * @param positions `#V by 3`
 * @param options displacements of the vertices, `#V by 3`
 */
export function drawShape(
  canvas: HTMLCanvasElement,
  { faceOffsets, faceIndices }: Pick<Connectivity, 'faceOffsets' | 'faceIndices'>,
  positions: ArrayLike<number>,
  {
    up,
    displacements,
    from = FROM,
  }: { up: 'y' | 'z'; displacements?: ArrayLike<number>; from?: typeof FROM },
) {
  const { clientWidth: width, clientHeight: height } = canvas;
  const context = canvas.getContext('2d');
  if (!context || width === 0) return;
  canvas.width = DENSITY * width;
  canvas.height = DENSITY * height;
  const { points, scale, centre } = viewed(positions, faceIndices, up, from, canvas);
  const displacement = displacements ? relativeLengths(displacements) : null;
  const plain = channels(colourOf(canvas, '--material'));
  const accent = channels(colourOf(canvas, '--accent'));
  const faces = faceOffsets.length - 1;
  const depths = new Float32Array(faces);
  for (let face = 0; face < faces; face++) {
    const [start, end] = [faceOffsets[face], faceOffsets[face + 1]];
    for (let k = start; k < end; k++)
      depths[face] += points[3 * faceIndices[k] + 2] / (end - start);
  }
  const order = Uint32Array.from(depths.keys()).sort((a, b) => depths[a] - depths[b]);
  for (const face of order) {
    const corners = faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);
    const isFace = corners.length > 2;
    context.lineWidth = isFace ? SEAM : LINE;
    const light = 0.55 + 0.45 * facing(points, corners);
    let part = 0;
    if (displacement) for (const v of corners) part += displacement[v] / corners.length;
    const shaded = plain.map((value, c) => light * (value + part * (accent[c] - value)));
    const colour = isFace ? shaded : accent;
    context.fillStyle = context.strokeStyle = `rgb(${colour.map(Math.round).join(' ')})`;
    context.beginPath();
    for (const v of corners) {
      const x = canvas.width / 2 + scale * (points[3 * v] - centre[0]);
      const y = canvas.height / 2 - scale * (points[3 * v + 1] - centre[1]);
      if (corners.length > 1) context.lineTo(x, y);
      else context.arc(x, y, DOT, 0, 2 * Math.PI);
    }
    context.closePath();
    context.fill();
    // Covers the seams between neighbours.
    context.stroke();
  }
}

/**
 * Returns positions in view coordinates: to the right, up, and towards the viewer. They are counted from
 * a vertex: those of a site are too large for single precision.
 * @param used vertices that are in the picture
 */
function viewed(
  positions: ArrayLike<number>,
  used: Uint32Array,
  up: 'y' | 'z',
  { turn, above }: typeof FROM,
  { width, height }: { width: number; height: number },
) {
  const points = new Float32Array(positions.length);
  const [sine, cosine] = [Math.sin(turn), Math.cos(turn)];
  const [down, level] = [Math.sin(above), Math.cos(above)];
  const origin = 3 * (used[0] ?? 0);
  for (let i = 0; i < positions.length; i += 3) {
    const x = positions[i] - positions[origin];
    const y = positions[i + 1] - positions[origin + 1];
    const z = positions[i + 2] - positions[origin + 2];
    const [back, top] = up === 'z' ? [y, z] : [-z, y];
    const right = cosine * x + sine * back;
    const far = -sine * x + cosine * back;
    points[i] = right;
    points[i + 1] = level * top + down * far;
    points[i + 2] = down * top - level * far;
  }
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (const v of used) {
    for (let c = 0; c < 2; c++) {
      low[c] = Math.min(low[c], points[3 * v + c]);
      high[c] = Math.max(high[c], points[3 * v + c]);
    }
  }
  const scale =
    FILLED * Math.min(width / (high[0] - low[0] || 1), height / (high[1] - low[1] || 1));
  return { points, scale, centre: low.map((value, c) => (value + high[c]) / 2) };
}

/** Returns the lengths of displacements, relative to the longest. */
function relativeLengths(displacements: ArrayLike<number>) {
  const lengths = new Float32Array(displacements.length / 3);
  let most = 0;
  for (let v = 0; v < lengths.length; v++) {
    lengths[v] = Math.hypot(
      displacements[3 * v],
      displacements[3 * v + 1],
      displacements[3 * v + 2],
    );
    most = Math.max(most, lengths[v]);
  }
  return lengths.map((value) => value / (most || 1));
}

/** How directly a face is seen, from 0 to 1. */
function facing(points: Float32Array, corners: Uint32Array) {
  let [x, y, z] = [0, 0, 0];
  corners.forEach((v, k) => {
    const [a, b] = [3 * v, 3 * corners[(k + 1) % corners.length]];
    x += points[a + 1] * points[b + 2] - points[a + 2] * points[b + 1];
    y += points[a + 2] * points[b] - points[a] * points[b + 2];
    z += points[a] * points[b + 1] - points[a + 1] * points[b];
  });
  return Math.abs(z) / (Math.hypot(x, y, z) || 1);
}

/** @param colour as CSS computes it */
const channels = (colour: string) => (colour.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
