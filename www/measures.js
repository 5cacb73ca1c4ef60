/** The error measures of a face, in words, and which of them a scene is about. */

/** @typedef {import("./messages.js").Measure} Measure */

/**
 * `label` names the measure, `words` say what it is, and `met` is what a panel without error is.
 * @type {Record<Measure, { label: string, words: string, met: string }>}
 */
export const MEASURES = {
  planarity: {
    label: 'Planarity',
    words: 'largest distance of a face’s corners to its best plane',
    met: 'flat',
  },
  circularity: {
    label: 'Circularity',
    words: 'largest distance of a face’s corners to its best circle',
    met: 'round',
  },
  residual: {
    label: 'Constraints',
    words: 'largest distance of a face’s corners to where their constraints want them',
    met: 'as they should be',
  },
};

/**
 * The largest error of all faces, in the unit of the mesh.
 * @param {import("./messages.js").Numbers} numbers
 * @param {Measure} measure
 * @returns {number}
 */
export function worstOf(numbers, measure) {
  return measure === 'residual' ? Math.max(0, ...numbers.worst) : numbers[measure].max_distance;
}

/**
 * The measure of what is asked of the faces: of the first row that is on and has one. The distance
 * to the constraints where rows ask for something that no other tells, none where nothing is asked
 * or there are no faces.
 * @param {Readonly<import("./state.js").State>} state
 * @returns {Measure | null}
 */
export function measureOfScene({ document, model }) {
  const rows = document?.constraints ?? [];
  if (rows.length === 0 || model?.faces === 0) return null;
  const measured = rows.find(({ enabled, measure }) => enabled && measure !== null);
  return measured?.measure ?? 'residual';
}
