/** A slider whose value counts when it is released. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import type { ComponentProps } from 'preact';

/**
 * Stays where it is held, whatever value comes meanwhile. Every gesture that has moved it ends with one
 * release: browsers tell of no change where it ends at the value at which it began.
 */
export function HeldSlider({
  at,
  onMove,
  onRelease,
  ...rest
}: Omit<ComponentProps<'input'>, 'value' | 'type' | 'role' | 'list'> & {
  at: number;
  onMove?: (to: number) => unknown;
  onRelease: (at: number) => unknown;
}) {
  const slider = useRef<HTMLInputElement>(null);
  const isMoved = useRef(false);
  useLayoutEffect(() => {
    const { current } = slider;
    // Each time: browsers clamp the value when the range changes.
    if (current && !current.matches(':active')) current.value = String(at);
  });
  const end = () => {
    if (isMoved.current && slider.current) onRelease(slider.current.valueAsNumber);
    isMoved.current = false;
  };
  return (
    <input
      ref={slider}
      type="range"
      onInput={({ currentTarget }) => {
        isMoved.current = true;
        onMove?.(currentTarget.valueAsNumber);
      }}
      onChange={end}
      onPointerUp={end}
      onBlur={end}
      {...rest}
    />
  );
}
