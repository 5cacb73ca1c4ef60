/** Keys of the view while it has the focus: arrows orbit, page keys zoom. */

/** An arrow key orbits like a drag of so many CSS pixels; a page key zooms by this factor. */
const ORBIT_STEP = 24;
const ZOOM_STEP = 1.25;

/** @type {Record<string, [number, number]>} */
const ORBITS = {
  ArrowLeft: [-ORBIT_STEP, 0],
  ArrowRight: [ORBIT_STEP, 0],
  ArrowUp: [0, -ORBIT_STEP],
  ArrowDown: [0, ORBIT_STEP],
};
/** @type {Record<string, number>} */
const ZOOMS = { PageUp: ZOOM_STEP, PageDown: 1 / ZOOM_STEP };

/** @param {import("../viewport.js").Viewport} viewport */
export function bindViewKeys(viewport) {
  const { element } = viewport;
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const orbit = ORBITS[event.key];
    const zoom = ZOOMS[event.key];
    if (!orbit && !zoom) return;
    event.preventDefault();
    viewport.with((view) => {
      if (orbit) view.orbit(...orbit);
      else view.zoom(zoom, element.clientWidth / 2, element.clientHeight / 2);
    });
  });
}
