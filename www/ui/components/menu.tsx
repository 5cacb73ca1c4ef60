/** Menus. */

import { useEffect, useRef } from 'preact/hooks';
import { placeMenu } from '../controls/navigation.ts';
import type { ComponentProps, RefObject } from 'preact';

type Props = Omit<ComponentProps<'div'>, 'ref'>;

/**
 * A popover that opens at what `anchor` returns, inside the window, with the arrow keys between its items.
 * @param props.of its element, for those who close it
 */
export function Menu({
  of,
  anchor,
  ...rest
}: Props & {
  of: RefObject<HTMLDivElement | null>;
  anchor: () => Pick<Element, 'getBoundingClientRect'>;
}) {
  const latest = useRef(anchor);
  latest.current = anchor;
  useEffect(() => {
    if (of.current) placeMenu(of.current, () => latest.current());
  }, [of]);
  return <div ref={of} popover="auto" class="menu" {...rest} />;
}

/** What an item of a menu says, in two lines. */
export const Entry = ({ title, children }: Pick<Props, 'children'> & { title: string }) => (
  <span class="entry">
    <strong>{title}</strong>
    <span>{children}</span>
  </span>
);
