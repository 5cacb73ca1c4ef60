/** What is made without components, inside one. */

import { useLayoutEffect, useRef } from 'preact/hooks';

/** Shows a node that was made elsewhere. */
export function Hosted({ node }: { node: Node }) {
  const place = useRef<HTMLSpanElement>(null);
  useLayoutEffect(() => place.current?.replaceChildren(node), [node]);
  return <span class="hosted" ref={place} />;
}
