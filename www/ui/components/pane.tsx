/** A part of the page with a title, which is closed by a cross or by Escape. */

import type { ComponentChildren, Ref } from 'preact';
import { CloseButton } from './buttons.tsx';

/**
 * @param props.id of the part
 * @param props.row the class of the row of the title
 * @param props.head what is beside the title
 */
export function Pane({
  row,
  title,
  head,
  place,
  close,
  children,
  ...rest
}: Record<'id' | 'class' | 'row' | 'title', string> & {
  head?: ComponentChildren;
  place?: Ref<HTMLElement>;
  close: () => void;
  children: ComponentChildren;
}) {
  const heading = `heading-${rest.id}`;
  return (
    <section
      ref={place}
      {...rest}
      aria-labelledby={heading}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        close();
      }}
    >
      <div class={row}>
        <h2 id={heading}>{title}</h2>
        {head}
        <CloseButton label={`Close ${title.toLowerCase()}`} onClick={close} />
      </div>
      {children}
    </section>
  );
}
