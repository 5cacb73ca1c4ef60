/** A panel docked below the view, which shrinks. */

import './docked.css';
import { useLayoutEffect } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { useApp } from '../store/use-app.ts';
import { CloseButton } from '../ui/components/buttons.tsx';
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
  const { actions, viewport } = useApp();
  const [id, heading] = [`${of}-panel`, `heading-${of}`];
  useLayoutEffect(() => {
    const { dataset } = document.body;
    dataset.docked = id;
    return () => {
      // The next panel may be there already.
      if (dataset.docked === id) delete dataset.docked;
    };
  }, [id]);
  function close() {
    actions.dock(null);
    viewport.element.focus({ preventScroll: true });
  }
  return (
    <section
      id={id}
      class="docked"
      aria-labelledby={heading}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        close();
      }}
    >
      <div class="heading-row">
        <h2 id={heading}>{title}</h2>
        {head}
        <CloseButton label={`Close ${title.toLowerCase()}`} onClick={close} />
      </div>
      {children}
    </section>
  );
}
