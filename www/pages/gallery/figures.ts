/** Headings of the gallery: the topics of the paper's figures. */

const TITLES: Record<number, string> = {
  1: 'one solver, many geometries',
  4: 'local and global step',
  5: 'planar and circular panels',
  6: 'shape exploration',
  7: 'mesh quality',
  8: 'deformation',
  9: 'conformal parametrisation',
  10: 'convergence',
  11: 'collapsing edges',
};

/** The heading of the lessons. */
export const LESSONS = 'Lessons';

/** @param after kind of the preceding section */
export function headingOf(figure: number | null, after: 'first' | 'figure' | 'lesson') {
  if (figure === null)
    return {
      first: 'To begin with',
      figure: 'Curves and points',
      lesson: 'Limits and other uses',
    }[after];
  const title = TITLES[figure];
  return title ? `Figure ${figure}: ${title}` : `Figure ${figure}`;
}
