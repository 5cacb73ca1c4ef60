/** A panel docked below the view, which shrinks. */

import './docked.css';
import { useLayoutEffect } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { useApp } from '../store/use-app.ts';
import { Pane } from '../ui/components/pane.tsx';
import type { State } from '../store/state.ts';

/**
 * @param of whose panel it is
 * @param head what is beside the title
 */
export function Docked({
  of,
  title,
  head,
  children,
}: {
  of: NonNullable<State['docked']>;
  title: string;
  head: ComponentChildren;
  children: ComponentChildren;
}) {
  const { actions } = useApp();
  const id = `${of}-panel`;
  useLayoutEffect(() => {
    const { dataset } = document.body;
    dataset.docked = id;
    return () => {
      // The next panel may be there already.
      if (dataset.docked === id) delete dataset.docked;
    };
  }, [id]);
  return (
    <Pane
      {...{ id, title, head }}
      class="docked"
      row="heading-row"
      close={() => actions.look({ docked: null })}
    >
      {children}
    </Pane>
  );
}
