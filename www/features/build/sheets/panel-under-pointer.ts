/** Tracks the panel under the pointer in the view, except during a drag. */

import type { Viewport } from '../../../viewport/viewport.ts';

/** A press that moves farther than this, in CSS pixels, is a drag of the view. */
const STILL = 4;

/**
 * @param on.point called when the panel changes
 * @param on.press called when the panel is clicked
 */
export function panelUnderPointer(
  viewport: Pick<Viewport, 'element' | 'with'>,
  {
    isAsked,
    point,
    press,
  }: { isAsked: () => boolean; point: (panel: number | undefined) => void; press: () => void },
) {
  const { element } = viewport;
  let pointed: number | undefined;
  let [startX, startY] = [0, 0];

  function become(panel: number | undefined) {
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
