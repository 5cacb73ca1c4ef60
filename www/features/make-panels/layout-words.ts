/** What is said of new panels: sentences, notes that show their places, and forecasts. */

import { element } from '../../ui/dom.ts';
import type { BoundaryForecast, LayoutNote } from '../../pkg/engine/shape_up.js';

/**
 * The paragraphs of a sentence and its notes. A note that names places is a button.
 * @param show brings the vertices around a place into view; pressed again, those of the next one
 */
export function paragraphs(
  words: string,
  notes: LayoutNote[],
  show: (vertices: number[]) => void,
): HTMLElement[] {
  const note = ({ words, places }: LayoutNote) => {
    if (!places.length) return element('p', words);
    let next = 0;
    const onclick = () => show(places[next++ % places.length]);
    const title = places.length > 1 ? 'Shows one place after another' : 'Shows the place';
    return element('p', element('button.place', { onclick, title }, words));
  };
  return [element('p', words), ...notes.map(note)];
}

/**
 * The forecasts of the choices at the boundary.
 * @param labels the choices, each with the label of its option and a shorter one
 * @param known the forecasts; null until they are known
 * @param shown the choice that is shown
 */
export function boundaryForecasts(
  labels: [BoundaryForecast['boundary'], string, string][],
  known: BoundaryForecast[] | null,
  shown: BoundaryForecast['boundary'] | null,
): HTMLElement[] {
  return labels.map(([boundary, , label]) => {
    const words = known?.find((one) => one.boundary === boundary)?.words ?? '…';
    const current = boundary === shown;
    return element(
      'div',
      { 'aria-current': String(current) },
      element('dt', label),
      element('dd', words),
    );
  });
}
