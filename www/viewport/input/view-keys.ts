/** Keys of a picture while it has the focus: arrows move it, page keys zoom it. */

import { ARROWS } from '../../ui/keys.ts';
import type { Viewport } from '../viewport.ts';

/** An arrow key orbits like a drag of so many CSS pixels; a page key zooms by this factor. */
const ORBIT_STEP = 24;
const ZOOM_STEP = 1.25;

const ZOOMS: Record<string, number> = { PageUp: ZOOM_STEP, PageDown: 1 / ZOOM_STEP };

/**
 * @param place of the picture
 * @param on.move in the direction of an arrow
 * @param on.zoom about the centre of the place
 */
export function bindMoveKeys(
  place: HTMLElement,
  {
    move,
    zoom,
  }: { move: (x: number, y: number) => void; zoom: (factor: number, x: number, y: number) => void },
) {
  place.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    const factor = ZOOMS[event.key];
    if (!arrow && !factor) return;
    event.preventDefault();
    if (arrow) move(...arrow);
    else zoom(factor, place.clientWidth / 2, place.clientHeight / 2);
  });
}

export function bindViewKeys(viewport: Viewport) {
  bindMoveKeys(viewport.element, {
    move: (x, y) => viewport.with((view) => view.orbit(ORBIT_STEP * x, ORBIT_STEP * y)),
    zoom: (...about) => viewport.with((view) => view.zoom(...about)),
  });
}
