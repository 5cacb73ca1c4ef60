/** Small pictures of the steps: each its shape, from where it is seen. */

import { drawShape } from '../../ui/plot/thumbnail.js';

/** @typedef {import("../../solver/messages.js").Slide} Slide */

/** Where turn and tilt are in the numbers of a camera. */
const [TURN, TILT] = [4, 5];

/**
 * @param {Pick<import("../../app/context.js").AppContext, "store" | "solver">} app
 * @returns {(canvas: HTMLCanvasElement, step: Slide) => void} draws into a canvas that is on the page
 */
export function stepPictures({ store, solver }) {
  const { mesh, variants } = JSON.parse(solver.sceneText ?? '{}');
  const { document: scene } = store.get();
  const shapeOf = (/** @type {Slide} */ { original, variant }) => {
    const kept = variant === undefined ? undefined : variants?.kept[variant]?.positions;
    const rows = original ? mesh?.positions : kept;
    return rows?.flat() ?? solver.geometry?.positions;
  };
  return (canvas, step) => {
    const { connectivity } = solver.geometry ?? {};
    const positions = shapeOf(step);
    if (!connectivity || !scene || !positions) return;
    const { camera } = step;
    const from = camera && { turn: camera[TURN], above: camera[TILT] };
    drawShape(canvas, connectivity, positions, { up: scene.up, from });
  };
}
