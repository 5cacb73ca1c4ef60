/** A small picture of a shape. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { drawShape } from '../../ui/plot/thumbnail.ts';
import type { Connectivity } from '../../solver/types.ts';

export function Thumbnail({
  connectivity,
  shape,
  up,
  displacements,
}: {
  connectivity: Connectivity;
  /** `#V by 3` */
  shape: Float64Array;
  up: 'y' | 'z';
  /** of the vertices, which colour it; `#V by 3` */
  displacements?: Float32Array;
}) {
  const { dark } = useApp().store.state;
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    if (canvas.current) drawShape(canvas.current, connectivity, shape, { up, displacements });
  }, [connectivity, shape, up, displacements, dark]);
  return <canvas ref={canvas} aria-hidden="true" />;
}
