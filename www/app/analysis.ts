/** The analysis region: a tab for each plot and table, which is made when it is first shown. */

import { itemByKey } from '../ui/controls/navigation.ts';
import { element } from '../ui/dom.ts';
import { reveal } from '../ui/reveal.ts';
import { anglesPanel } from '../panels/angles.ts';
import { Convergence } from '../panels/convergence.ts';
import { logOf } from '../panels/log.ts';
import { worstElements } from '../panels/worst.ts';
import type { AppContext } from './context.ts';

interface Tab {
  id: string;
  label: string;
  /** fills the panel; called once */
  make: (panel: HTMLElement, app: AppContext) => unknown;
}

/** The tabs in display order. */
const TABS: Tab[] = [
  {
    id: 'convergence',
    label: 'Convergence',
    make: (panel, app) => new Convergence(panel, app),
  },
  { id: 'angles', label: 'Angles', make: anglesPanel },
  { id: 'worst', label: 'Worst', make: worstElements },
  { id: 'log', label: 'Log', make: logOf },
];

/** @returns shows a tab and scrolls the region into view */
export function analysisRegion(place: HTMLElement, app: AppContext): (id: string) => Promise<void> {
  const { store, actions } = app;
  const list = element('div', { role: 'tablist', 'aria-label': 'Analysis' });
  const entries = TABS.map((tab) => {
    const button = element(
      'button',
      {
        role: 'tab',
        id: `tab-${tab.id}`,
        'aria-controls': tab.id,
        onclick: () => actions.look({ plot: tab.id }),
      },
      tab.label,
    );
    const panel = element('div', {
      id: tab.id,
      role: 'tabpanel',
      'aria-labelledby': `tab-${tab.id}`,
    });
    return { ...tab, button, panel, isMade: false };
  });
  list.append(...entries.map(({ button }) => button));
  place.append(list, ...entries.map(({ panel }) => panel));

  list.addEventListener('keydown', (event) => {
    const buttons = entries.map(({ button }) => button);
    const next = itemByKey(event, buttons, { along: 'x' });
    next?.focus();
    next?.click();
  });

  function show(id: string) {
    // A saved view may name a tab that does not exist.
    const entry = entries.find((one) => one.id === id);
    if (!entry) return;
    for (const { id: other, panel, button } of entries) {
      const isShown = other === id;
      panel.hidden = !isShown;
      button.setAttribute('aria-selected', String(isShown));
      button.tabIndex = isShown ? 0 : -1;
    }
    if (!entry.isMade) entry.make(entry.panel, app);
    entry.isMade = true;
  }
  store.subscribe(['plot'], ({ plot }) => show(plot));
  return async (id) => {
    actions.look({ plot: id });
    await Promise.resolve();
    reveal(place);
  };
}
