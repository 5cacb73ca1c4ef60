/** The selection: sets of vertices, edges and faces, and how clicks and regions change them. */

import { count } from '../ui/format.js';

/** @typedef {import("./state.js").Selection} Selection */
/** @typedef {import("./state.js").Mode} Mode */
/** @typedef {"replace" | "add" | "remove"} Combine */

/** @type {Selection} */
export const NOTHING = { vertices: new Set(), edges: new Set(), faces: new Set() };

/**
 * Rhino's rule: Shift adds, Ctrl or Cmd removes.
 * @param {{ shiftKey: boolean, ctrlKey: boolean, metaKey: boolean }} event
 * @returns {Combine}
 */
export function combineOf(event) {
  if (event.ctrlKey || event.metaKey) return 'remove';
  return event.shiftKey ? 'add' : 'replace';
}

/**
 * @param {Selection} selection
 * @param {Mode} mode kind of the `items`
 * @param {Iterable<number>} items
 * @param {Combine} combine
 * @returns {Selection}
 */
export function select(selection, mode, items, combine) {
  if (combine === 'replace') return { ...NOTHING, [mode]: new Set(items) };
  const next = new Set(selection[mode]);
  for (const item of items) {
    if (combine === 'add') next.add(item);
    else next.delete(item);
  }
  return { ...selection, [mode]: next };
}

/** Number of selected elements. @param {Selection} selection */
export function sizeOfSelection({ vertices, edges, faces }) {
  return vertices.size + edges.size + faces.size;
}

/**
 * Returns the vertices, the ends of the edges and the corners of the faces, ascending.
 * @param {Record<Mode, Iterable<number>>} elements
 * @param {import("../solver/messages.js").Connectivity} connectivity
 * @returns {number[]}
 */
export function verticesOf(elements, connectivity) {
  const { edges } = connectivity;
  const vertices = new Set(elements.vertices);
  for (const edge of elements.edges) vertices.add(edges[2 * edge]).add(edges[2 * edge + 1]);
  for (const face of elements.faces)
    for (const vertex of cornersOf(connectivity, face)) vertices.add(vertex);
  return [...vertices].sort((a, b) => a - b);
}

/**
 * Returns the corners of a face.
 * @param {import("../solver/messages.js").Connectivity} connectivity
 * @param {number} face
 */
export function cornersOf({ faceOffsets, faceIndices }, face) {
  return faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);
}

/** Describes the selection; empty if nothing is selected. @param {Selection} selection */
export function describe(selection) {
  const parts = [];
  if (selection.vertices.size > 0) parts.push(count(selection.vertices.size, 'vertex', 'vertices'));
  if (selection.edges.size > 0) parts.push(count(selection.edges.size, 'edge'));
  if (selection.faces.size > 0) parts.push(count(selection.faces.size, 'face'));
  return parts.join(', ');
}
