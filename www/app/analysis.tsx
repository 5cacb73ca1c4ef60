/** The analysis region: a tab for each plot and table, which is made when it is first shown. */

import { useRef } from 'preact/hooks';
import { Angles } from '../panels/angles.tsx';
import { Convergence } from '../panels/convergence.tsx';
import { Log } from '../panels/log.tsx';
import { WorstElements } from '../panels/worst.tsx';
import { useApp } from '../store/use-app.ts';
import { itemByKey } from '../ui/controls/navigation.ts';
import type { ComponentType } from 'preact';

interface Tab {
  id: string;
  label: string;
  Content: ComponentType;
}

/** The tabs in display order. */
const TABS: Tab[] = [
  { id: 'convergence', label: 'Convergence', Content: Convergence },
  { id: 'angles', label: 'Angles', Content: Angles },
  { id: 'worst', label: 'Worst', Content: WorstElements },
  { id: 'log', label: 'Log', Content: Log },
];

export function Analysis() {
  const { store, actions } = useApp();
  const { plot } = store.state;
  // A saved view may name a tab that does not exist.
  const { id: shown } = TABS.find(({ id }) => id === plot) ?? TABS[0];
  const buttons = useRef<(HTMLButtonElement | null)[]>([]);
  return (
    <>
      <div
        role="tablist"
        aria-label="Analysis"
        onKeyDown={(event) => {
          const tabs = buttons.current.filter((button) => button !== null);
          const next = itemByKey(event, tabs, { along: 'x' });
          next?.focus();
          next?.click();
        }}
      >
        {TABS.map(({ id, label }, i) => (
          <button
            key={id}
            ref={(button) => {
              buttons.current[i] = button;
            }}
            type="button"
            role="tab"
            id={`tab-${id}`}
            aria-controls={id}
            aria-selected={id === shown}
            tabIndex={id === shown ? 0 : -1}
            onClick={() => actions.look({ plot: id })}
          >
            {label}
          </button>
        ))}
      </div>
      {TABS.map((tab) => (
        <Panel key={tab.id} tab={tab} isShown={tab.id === shown} />
      ))}
    </>
  );
}

function Panel({ tab: { id, Content }, isShown }: { tab: Tab; isShown: boolean }) {
  const wasShown = useRef(false);
  wasShown.current ||= isShown;
  return (
    <div id={id} role="tabpanel" aria-labelledby={`tab-${id}`} hidden={!isShown}>
      {wasShown.current && <Content />}
    </div>
  );
}
