/** Tracks the panel under the pointer in the view, except during a drag. */

/** A press that moves farther than this, in CSS pixels, is a drag of the view. */
const STILL = 4;

/**
 * @param {Pick<import("../../../viewport/viewport.js").Viewport, "element" | "with">} viewport
 * @param {object} on
 * @param {() => boolean} on.isAsked
 * @param {(panel: number | undefined) => void} on.point called when the panel changes
 * @param {() => void} on.press called when the panel is clicked
 */
export function panelUnderPointer(viewport, { isAsked, point, press }) {
  const { element } = viewport;
  /** @type {number | undefined} */
  let pointed;
  let [startX, startY] = [0, 0];

  /** @param {number | undefined} panel */
  function become(panel) {
    if (panel === pointed) return;
    pointed = panel;
    point(panel);
  }

  element.addEventListener('pointermove', ({ clientX, clientY, buttons, pointerType }) => {
    if (!isAsked() || buttons !== 0 || pointerType === 'touch') return;
    const { left, top } = element.getBoundingClientRect();
    become(viewport.with((view) => view.pickFace(clientX - left, clientY - top)));
  });
  element.addEventListener('pointerleave', () => become(undefined));
  element.addEventListener('pointerdown', ({ clientX, clientY }) => {
    [startX, startY] = [clientX, clientY];
  });
  element.addEventListener('click', ({ clientX, clientY }) => {
    const isStill = Math.hypot(clientX - startX, clientY - startY) < STILL;
    if (pointed !== undefined && isStill && isAsked()) press();
  });
}
