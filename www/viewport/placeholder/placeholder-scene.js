/**
 * Placeholder picture of the first example, which the build inserts into the page. It is shown
 * until the view has drawn or another model is opened. Until then its mesh follows the solver, and
 * drags of its handles (placeholder-drag.js) are sent to the solver.
 */

import { HandleDrag } from '../../store/handle-drag.js';

/**
 * A drag of a handle in the placeholder: start and end in pixels of the picture, and the
 * displacements per pixel to the right and per pixel down.
 * @typedef {object} EarlyDrag
 * @property {number} vertex
 * @property {[number, number]} from
 * @property {[number, number]} to
 * @property {number[]} right
 * @property {number[]} down
 * @property {boolean} ended
 */

/**
 * State of placeholder-drag.js in `window.earlyDrags`; it calls `changed` after each change.
 * @typedef {{ drags: EarlyDrag[], changed: () => void }} EarlyDrags
 */

/** Number of corners of a polygon that approximates a circle. */
const CORNERS = 20;

const find = () => document.getElementById('first-picture');

/** While the placeholder is shown, the view ignores presses. */
export const isPlaceholderShown = () => find() !== null;

export function removePlaceholder() {
  find()?.remove();
}

/** @param {string | undefined} text */
const numbersOf = (text) => (text ?? '').split(' ').map(Number);

/**
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 */
export function animatePlaceholder(store, solver) {
  solver.on('frame', () => {
    const picture = find();
    if (picture && solver.geometry) draw(picture, solver.geometry);
  });
  takeOverDrags(store, solver);
}

/**
 * @param {HTMLElement} picture
 * @param {import("../../solver/solver-client.js").Geometry} geometry
 */
function draw(picture, { connectivity: { faceOffsets, faceIndices }, positions, shapes }) {
  const order = numbersOf(picture.dataset.faces);
  const isOther = faceOffsets.length !== order.length + 1;
  if (isOther) return;
  for (const svg of picture.querySelectorAll('svg')) {
    if (svg.getClientRects().length === 0) continue;
    const project = projection(numbersOf(svg.dataset.eye));
    const place = (/** @type {number} */ vertex) =>
      project(positions.subarray(3 * vertex, 3 * vertex + 3));
    /** @type {string[]} */
    let corners = [];
    let drawn = 0;
    for (const path of svg.querySelectorAll(':scope > path')) {
      if (!(path instanceof SVGPathElement)) continue;
      const { sides } = path.dataset;
      if (sides === undefined) {
        const face = order[drawn++];
        const vertices = faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);
        corners = Array.from(vertices, (vertex) => place(vertex).join(' '));
        path.setAttribute('d', `M${corners.join('L')}z`);
      } else {
        const ends = (/** @type {number} */ side) =>
          `M${corners[side]}L${corners[(side + 1) % corners.length]}`;
        path.setAttribute('d', numbersOf(sides).map(ends).join(''));
      }
    }
    const circles = svg.querySelector('.circles');
    if (circles instanceof SVGPathElement && shapes) drawCircles(circles, shapes, project);
    for (const group of svg.querySelectorAll('g')) moveHandle(group, place);
  }
}

/**
 * Returns the projection of points into the picture.
 * @param {number[]} eye three rows of four: right, down, and the depth by which both are divided
 */
function projection(eye) {
  return (/** @type {ArrayLike<number>} */ point) => {
    const row = (/** @type {number} */ at) =>
      eye[at] * point[0] + eye[at + 1] * point[1] + eye[at + 2] * point[2] + eye[at + 3];
    const depth = row(8);
    return [row(0) / depth, row(4) / depth].map((value) => Math.round(10 * value) / 10);
  };
}

/**
 * Draws fitted circles as polygons.
 * @param {SVGPathElement} path
 * @param {Float64Array} shapes eight numbers each: 0 for a circle, centre, normal, radius
 * @param {(point: number[]) => number[]} project
 */
function drawCircles(path, shapes, project) {
  let data = '';
  for (let at = 0; at < shapes.length; at += 8) {
    const [kind, x, y, z, a, b, c, radius] = shapes.subarray(at, at + 8);
    if (kind !== 0) continue;
    // Two perpendicular radii: the first is horizontal, or along x if the circle is horizontal.
    const level = Math.hypot(a, b);
    const u = level > 0 ? [-b / level, a / level, 0] : [1, 0, 0];
    const v = [-c * u[1], c * u[0], a * u[1] - b * u[0]];
    const corners = Array.from({ length: CORNERS }, (_, i) => {
      const turn = (2 * Math.PI * i) / CORNERS;
      const [p, q] = [radius * Math.cos(turn), radius * Math.sin(turn)];
      return project([x, y, z].map((centre, axis) => centre + p * u[axis] + q * v[axis])).join(' ');
    });
    data += `M${corners.join('L')}z`;
  }
  path.setAttribute('d', data);
}

/**
 * Moves a handle to its vertex, and the start of its line; the line ends at the target.
 * @param {SVGGElement} group
 * @param {(vertex: number) => number[]} place
 */
function moveHandle(group, place) {
  const dot = group.querySelector('circle.handle');
  const pull = group.querySelector('path');
  if (!dot || !pull) return;
  const [x, y] = place(Number(group.dataset.vertex));
  dot.setAttribute('cx', `${x}`);
  dot.setAttribute('cy', `${y}`);
  const tip = (pull.getAttribute('d') ?? '').split('L')[1];
  if (tip) pull.setAttribute('d', `M${x} ${y}L${tip}`);
}

/**
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 */
function takeOverDrags(store, solver) {
  /** @type {Window & { earlyDrags?: EarlyDrags }} */
  const { earlyDrags } = window;
  if (!earlyDrags) return;
  let isReady = false;
  /** @type {HandleDrag | null} */
  let current = null;
  const takeOver = () => {
    // By now another model may have been opened.
    if (!isReady || !store.get().firstExample) return;
    while (earlyDrags.drags.length > 0) {
      const [{ vertex, from, to, right, down, ended }] = earlyDrags.drags;
      current ??= new HandleDrag(store, solver, planeOf(right, down), vertex);
      current.move(to[0] - from[0], to[1] - from[1]);
      if (!ended) return;
      current.end();
      current = null;
      earlyDrags.drags.shift();
    }
  };
  earlyDrags.changed = takeOver;
  store.subscribe(['document', 'firstExample'], ({ document, firstExample }) => {
    if (!document || !firstExample || isReady) return;
    isReady = true;
    takeOver();
  });
}

/**
 * Returns the displacement of a handle for a pointer displacement, like the view's `constrainMove`.
 * @param {number[]} right displacement per pixel
 * @param {number[]} down
 * @returns {import("../../store/handle-drag.js").MoveConstraint}
 */
const planeOf = (right, down) => (_, dx, dy) =>
  Float64Array.from(right, (value, axis) => value * dx + down[axis] * dy);
