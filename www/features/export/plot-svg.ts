/** The convergence plot as a figure: energies over iterations. */

import { PRINTED, linesSvg } from '../../ui/plot/lines-svg.ts';

/** In the order of the table's columns. */
const SERIES = ['shape', 'close', 'smooth', 'handles', 'total'];

/**
 * @param csv the table of iterations from the solver
 * @param units of the energies; empty if unknown
 */
export function convergenceSvg(csv: string, title: string, units: string) {
  const rows = csv.trim().split('\n').slice(1);
  const table = rows.map((row) => row.split(',').map(Number));
  const lines = SERIES.map((label, i) => ({
    label,
    colour: PRINTED[i],
    x: table.map(([iteration]) => iteration),
    y: table.map((row) => row[i + 1]),
    width: label === 'total' ? 2 : 1.25,
  }));
  return linesSvg(lines, { title, x: 'iteration', y: `energy${units ? ` in ${units}` : ''}` });
}
