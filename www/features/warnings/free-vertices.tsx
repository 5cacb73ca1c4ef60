/**
 * Vertices on which a constraint does not act: those that none acts on, which stay in place while the
 * rest moves, and those of a constraint on pairs, such as a symmetry, that have no partner.
 */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { newestOnly } from '../../store/latest-only.ts';
import { isLocked } from '../../store/panels-card.ts';
import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { count } from '../../ui/words.ts';
import type { Tint } from '../../store/state.ts';

/** The colour of their dots, sRGB bytes. */
const COLOUR: [number, number, number] = [214, 132, 24];
const NONE = new Uint32Array(0);
const ALL_FREE = { operation: 'free', mode: 'vertices' as const, from: {}, params: {} };

/** Marks vertices that no constraint acts on, and offers to let them follow or to fix them. */
export function FreeVertices() {
  const { store, actions } = useApp();
  const { document, model } = store.state;
  const acts = document?.constraints.some(({ enabled }) => enabled);
  const free = document && acts ? document.free : 0;
  const newest = useMemo(() => newestOnly(() => store.get().model), [store]);
  /** The marks of those that are reported, unless the report was closed. */
  const [found, setFound] = useState<{ of: typeof model; tint: Tint; isClosed: boolean } | null>(
    null,
  );
  // Those of a mesh that was replaced mean nothing on the next one.
  const marks = free > 0 && found?.of === model && !found.isClosed ? found.tint : null;
  // An edit may leave as many, but others.
  useEffect(() => {
    if (!document) return;
    const asked = free > 0 ? actions.reportErrors(actions.ask.select(ALL_FREE)) : null;
    void newest(asked).then((all) => {
      if (all === undefined) return;
      const tint = all && { vertices: all.vertices, faces: NONE, colour: COLOUR };
      setFound((before) =>
        before?.of === model && String(before?.tint.vertices) === String(tint?.vertices)
          ? before
          : tint && { of: model, tint, isClosed: false },
      );
    });
  }, [document]);
  useEffect(() => actions.tint('free', marks), [marks]);
  if (!marks) return null;

  const vertices = [...marks.vertices];
  const stand =
    free === 1
      ? 'vertex stands still: nothing acts on it.'
      : 'vertices stand still: nothing acts on them.';
  return (
    <div class="message notice" role="group" aria-label="Vertices that stand still">
      <p>{count(free, stand, stand)}</p>
      {!isLocked({ document }, 'weights') && (
        <Button
          class="small bordered"
          title="With these weights, the vertices follow the others"
          onClick={() => actions.edit({ preset: { id: 'opened' } })}
        >
          Use the weights of Keep the design
        </Button>
      )}
      {!isLocked({ document }, 'handles') && (
        <Button class="small bordered" onClick={() => actions.addHandles(vertices, true)}>
          Fix them
        </Button>
      )}
      <Button class="small bordered" onClick={() => actions.select({ vertices, faces: [] })}>
        Select
      </Button>
      <CloseButton label="Close" onClick={() => setFound(found && { ...found, isClosed: true })} />
    </div>
  );
}

/** Reports how many vertices have no partner. They are free; if none has one, the constraint does nothing. */
export function Unpaired() {
  const { document } = useApp().store.state;
  const words = (document?.unpaired ?? []).join(' ');
  const [isClosed, setClosed] = useState(false);
  useEffect(() => setClosed(false), [words]);
  if (!words || isClosed) return null;
  return (
    <div class="message notice" role="group" aria-label="Vertices without a partner">
      <p>{words}</p>
      <CloseButton label="Close" onClick={() => setClosed(true)} />
    </div>
  );
}
