/** The edges that a setting lists: the selected ones are added or taken out, or all are taken back. */

import { useMemo } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { count } from '../../ui/words.ts';
import { selectedEdges, without, type Edge } from './seams.ts';

export function SeamsField({
  label,
  title,
  edges,
  onEdges,
}: {
  label: string;
  title: string;
  edges: Edge[];
  /** returns nothing if they were refused */
  onEdges: (edges: Edge[]) => Promise<unknown>;
}) {
  const { solver, store, actions } = useApp();
  const { selection, model, tool, mode } = store.state;
  const chosen = useMemo(() => {
    const { geometry } = solver;
    return geometry ? selectedEdges(selection, geometry.connectivity) : [];
  }, [selection, model]);
  const added = without(chosen, edges);
  const folded = without(chosen, added);
  /** Changes them; what was selected would hide them. */
  async function change(to: Edge[]) {
    if ((await onEdges(to)) !== undefined) actions.selectNothing();
  }
  return (
    <div class="seams" role="group" aria-label={label} title={title}>
      <p aria-live="polite">
        {edges.length > 0
          ? `${count(edges.length, 'edge is', 'edges are')} cut.`
          : 'To choose where the pieces end, select edges of the model.'}
      </p>
      {(tool !== 'select' || mode !== 'edges') && (
        <Button onClick={() => actions.look({ tool: 'select', mode: 'edges' })}>
          Select edges
        </Button>
      )}
      <Button disabled={added.length === 0} onClick={() => change([...edges, ...added])}>
        Cut along the selected edges
      </Button>
      {folded.length > 0 && (
        <Button onClick={() => change(without(edges, folded))}>Fold the selected edges</Button>
      )}
      <Button disabled={edges.length === 0} onClick={() => onEdges([])}>
        No seams
      </Button>
    </div>
  );
}
