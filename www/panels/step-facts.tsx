/** What a step has, in its heading while it is closed. */

import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../store/use-app.ts';
import { byId } from '../ui/dom.ts';
import { count } from '../ui/format.ts';
import type { Step } from '../store/state.ts';

/** The number of constraints. */
export const ShapeFact = () => {
  const all = useApp().store.state.document?.constraints.length ?? 0;
  return <Fact step="shape">{all > 0 && count(all, 'constraint')}</Fact>;
};

/** The number of handles. */
export const MoveFact = () => {
  const all = useApp().store.state.document?.handles.length ?? 0;
  return <Fact step="move">{all > 0 && count(all, 'handle')}</Fact>;
};

function Fact({ step, children }: { step: Step; children: string | false }) {
  const [isClosed, setClosed] = useState(false);
  useEffect(() => {
    const place: HTMLDetailsElement = byId(`step-${step}`);
    const follow = () => setClosed(!place.open);
    follow();
    place.addEventListener('toggle', follow);
    return () => place.removeEventListener('toggle', follow);
  }, [step]);
  return <>{isClosed && children}</>;
}
