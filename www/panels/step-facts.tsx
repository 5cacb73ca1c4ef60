/** What a step has, in its heading. */

import { useApp } from '../store/use-app.ts';
import { count } from '../ui/words.ts';
import type { Step } from '../store/state.ts';

/** The name of the model: nowhere else, so that it is in sight whatever is open. */
export function ModelFact() {
  const { model, fileName } = useApp().store.state;
  const name = model && (model.title || fileName);
  return <span title={name ?? ''}>{name}</span>;
}

/** The number of constraints, while they are not listed. */
export const ShapeFact = () => {
  const all = useApp().store.state.document?.constraints.length ?? 0;
  return <Fact step="shape">{all > 0 && count(all, 'constraint')}</Fact>;
};

/** The number of handles, while nothing is said of them. */
export const MoveFact = () => {
  const all = useApp().store.state.document?.handles.length ?? 0;
  return <Fact step="move">{all > 0 && count(all, 'handle')}</Fact>;
};

function Fact({ step, children }: { step: Step; children: string | false }) {
  const { openSteps } = useApp().store.state;
  return <>{!openSteps.includes(step) && children}</>;
}
