/**
 * One sheet as SVG: a path for each layer, and above them one for each mark, regardless of the
 * number of parts. The part under the pointer is found by point-in-path tests on the outlines.
 */

import { useMemo } from 'preact/hooks';
import type { Ref } from 'preact';
import { useInSight } from '../../ui/components/use-in-sight.ts';
import { once } from '../../ui/once.ts';
import type { SheetPicture } from '../../pkg/engine/shape_up.js';

/** A sheet with the panels that exceed their limit. */
export interface Drawn {
  sheet: SheetPicture;
  failed: ReadonlySet<number>;
}

const ruler = document.createElement('canvas').getContext('2d');

/**
 * @param props.chosen the parts that are selected
 * @param props.isOnly whether they are the only ones of all sheets, and are scrolled to
 * @param props.pointed the parts under the pointer, here or in the view
 * @param props.point called with the part under the pointer here, or null
 * @param props.choose called with a part that is clicked
 */
export function Sheet({
  drawn: { sheet, failed },
  chosen,
  isOnly,
  pointed,
  mark,
  point,
  choose,
}: {
  drawn: Drawn;
  chosen: number[];
  isOnly: boolean;
  pointed: number[];
  /** the path of the parts under the pointer */
  mark: Ref<SVGPathElement>;
  point: (part: number | null) => void;
  choose: (part: number) => void;
}) {
  const { name, size, layers, colour, outlines, panels } = sheet;
  const all = useMemo(() => outlines.join(''), [sheet]);
  const failing = useMemo(
    () => outlines.filter((_, part) => panels[part].some((panel) => failed.has(panel))).join(''),
    [sheet, failed],
  );
  const pathOf = (parts: number[]) => parts.map((part) => outlines[part]).join('');
  const selected = pathOf(chosen);
  const only = useInSight<SVGPathElement>(isOnly && selected);

  /** For hit testing. */
  const areas = useMemo(() => once(() => outlines.map((outline) => new Path2D(outline))), [sheet]);
  function partAt({ clientX, clientY, currentTarget }: MouseEvent & { currentTarget: SVGElement }) {
    const toWindow = (currentTarget as SVGSVGElement).getScreenCTM();
    if (!toWindow) return null;
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(toWindow.inverse());
    const part = areas().findIndex((area) => ruler?.isPointInPath(area, x, y));
    return part < 0 ? null : part;
  }

  return (
    <figure>
      <svg
        role="img"
        aria-label={name}
        viewBox={`0 0 ${size.join(' ')}`}
        onPointerMove={(event) => point(partAt(event))}
        onPointerLeave={() => point(null)}
        onClick={(event) => {
          const part = partAt(event);
          if (part !== null) choose(part);
        }}
      >
        {layers.map((layer) => (
          <path
            key={layer.name}
            class={layer.name.toLowerCase()}
            d={layer.path}
            stroke={layer.colour}
          />
        ))}
        <path class="cut" d={all} stroke={colour} />
        <path class="failed" d={failing} />
        <path class="chosen" d={selected} ref={only} />
        <path class="failed-sides" d={sheet.failed} />
        <path class="pointed" d={pathOf(pointed)} ref={mark} />
      </svg>
      <figcaption>{name}</figcaption>
    </figure>
  );
}
