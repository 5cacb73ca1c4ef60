/** What a closed step has, in its heading. */

import { useApp } from '../store/use-app.ts';
import { count } from '../ui/format.ts';

/** The model. */
export function ModelFact() {
  const { model, fileName } = useApp().store.state;
  return <>{model && (model.title || fileName)}</>;
}

/** The constraints. */
export function ShapeFact() {
  const { document } = useApp().store.state;
  return (
    <>{document?.constraints.length ? count(document.constraints.length, 'constraint') : ''}</>
  );
}

/** The handles. */
export function MoveFact() {
  const { document } = useApp().store.state;
  return <>{document?.handles.length ? count(document.handles.length, 'handle') : ''}</>;
}
