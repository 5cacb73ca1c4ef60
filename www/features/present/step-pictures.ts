/** Thumbnails of the steps: the shape of each step, from its camera. */

import { drawShape } from '../../ui/plot/thumbnail.ts';
import type { Slide } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** Indices of turn and tilt in the array of a camera. */
const [TURN, TILT] = [4, 5];

/** @returns draws a step into a canvas */
export function stepPictures({
  store,
  solver,
}: Pick<AppContext, 'store' | 'solver'>): (canvas: HTMLCanvasElement, step: Slide) => void {
  const { mesh, variants } = JSON.parse(solver.sceneText ?? '{}');
  const { document: scene } = store.get();
  const shapeOf = ({ original, variant }: Slide) => {
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
