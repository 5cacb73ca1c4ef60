/** The selection: sets of vertices and of faces, and what clicks and boxes do to them. */

/** @typedef {import("./state.js").Selection} Selection */
/** @typedef {"replace" | "add" | "remove"} Combine */

/** @type {Selection} */
export const NOTHING = { vertices: new Set(), faces: new Set() };

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
 * @param {"vertices" | "faces"} mode which of the two `items` are
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

/**
 * The selected vertices and the corners of the selected faces, ascending.
 * @param {Selection} selection
 * @param {import("./messages.js").Connectivity} connectivity
 * @returns {number[]}
 */
export function selectedVertices(selection, { faceOffsets, faceIndices }) {
  const vertices = new Set(selection.vertices);
  for (const face of selection.faces) {
    for (let i = faceOffsets[face]; i < faceOffsets[face + 1]; i++) vertices.add(faceIndices[i]);
  }
  return [...vertices].sort((a, b) => a - b);
}

/**
 * The selection in words, empty when nothing is selected.
 * @param {Selection} selection
 * @param {(value: number, noun: string, plural?: string) => string} count
 */
export function describe(selection, count) {
  const parts = [];
  if (selection.vertices.size > 0) parts.push(count(selection.vertices.size, 'vertex', 'vertices'));
  if (selection.faces.size > 0) parts.push(count(selection.faces.size, 'face'));
  return parts.join(', ');
}
