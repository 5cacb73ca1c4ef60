/** A small picture of a shape. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { drawShape } from '../plot/thumbnail.ts';
import { useSize } from './use-size.ts';
import type { Connectivity } from '../../solver/types.ts';

export function Thumbnail({
  connectivity,
  shape,
  up,
  from,
  displacements,
  dark,
  label,
}: {
  connectivity: Connectivity;
  /** `#V by 3` */
  shape: ArrayLike<number>;
  up: 'y' | 'z';
  /** the direction of view, if other than usual */
  from?: { turn: number; above: number };
  /** of the vertices, which colour it; `#V by 3` */
  displacements?: Float32Array;
  /** whether its colours are those for a dark page */
  dark: boolean;
  /** what it is, where that is not said beside it */
  label?: string;
}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  // It has no size before it is measured, and in a dialog that is not open yet.
  const [width, height] = useSize(canvas);
  useLayoutEffect(() => {
    if (canvas.current && width > 0)
      drawShape(canvas.current, connectivity, shape, { up, from, displacements });
  }, [connectivity, shape, up, from?.turn, from?.above, displacements, dark, width, height]);
  return (
    <canvas
      ref={canvas}
      role={label ? 'img' : undefined}
      aria-label={label}
      aria-hidden={label ? undefined : 'true'}
    />
  );
}
