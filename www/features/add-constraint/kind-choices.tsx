/** Palette of the kinds of constraints: radio buttons with drawings, the paper's kinds first. */

import { useEffect, useRef } from 'preact/hooks';
import { useInSight } from '../../ui/components/use-in-sight.ts';
import { Drawing } from '../../ui/kinds/drawing.tsx';
import type { Ref } from 'preact';
import type { KindWords } from '../../pkg/engine/shape_up.js';

interface Props {
  kinds: KindWords[];
  /** the id of the chosen one, which has the focus at first */
  chosen: string;
  onChoose: (id: string) => unknown;
}

export function KindChoices({ kinds, ...rest }: Props) {
  const own = kinds.filter((kind) => kind.paper);
  const others = kinds.filter((kind) => !kind.paper);
  const radio = useRef<HTMLInputElement>(null);
  useEffect(() => {
    // After the other choices have come into sight, which may scroll this one out of it.
    const request = requestAnimationFrame(() => radio.current?.focus());
    return () => cancelAnimationFrame(request);
  }, []);
  return (
    <div class="kinds">
      {own.length > 0 && <Palette kinds={own} radio={radio} {...rest} />}
      {others.length > 0 && (
        <>
          <p class="quiet heading">Other constraints</p>
          <Palette kinds={others} radio={radio} {...rest} />
        </>
      )}
    </div>
  );
}

/** What gives access to the radio button of the chosen kind. */
type Radio = Ref<HTMLInputElement>;

function Palette({ kinds, chosen, radio, onChoose }: Props & { radio: Radio }) {
  return (
    <div class="palette">
      {kinds.map((kind) => {
        const isChosen = kind.id === chosen;
        return (
          <Tile
            key={kind.id}
            kind={kind}
            isChosen={isChosen}
            radio={isChosen ? radio : null}
            choose={() => onChoose(kind.id)}
          />
        );
      })}
    </div>
  );
}

function Tile({
  kind: { id, label, summary, colour, sketch },
  isChosen,
  radio,
  choose,
}: {
  kind: KindWords;
  isChosen: boolean;
  radio: Radio;
  choose: () => unknown;
}) {
  const place = useInSight<HTMLLabelElement>(isChosen);
  return (
    <label
      ref={place}
      class="tile"
      title={summary}
      style={{ '--chip': `rgb(${colour.join(' ')})` }}
    >
      <input
        ref={radio}
        type="radio"
        name="new-kind"
        id={`new-kind-${id}`}
        aria-label={label}
        aria-describedby={`new-kind-${id}-summary`}
        checked={isChosen}
        onChange={choose}
      />
      <Drawing of={sketch} />
      <span>{label}</span>
      {/* The summary of the chosen kind is shown below the palette; screen readers get each. */}
      <span class="visually-hidden" id={`new-kind-${id}-summary`}>
        {summary}
      </span>
    </label>
  );
}
