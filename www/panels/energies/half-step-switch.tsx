/** The switch that is on between the two halves of an iteration. */

import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { Icon } from '../../ui/components/buttons.tsx';

export function HalfStepSwitch() {
  const { halfway } = useApp().store.state;
  return (
    <CommandButton of="half-step" role="switch" aria-checked={halfway}>
      <Icon name={halfway ? 'global' : 'local'} />
      Half step
    </CommandButton>
  );
}
