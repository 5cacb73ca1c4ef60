/**
 * The parts of the layout for narrow windows that style sheets cannot do: the tabs of the panels,
 * the bottom sheet, and moving the groups of the toolbar.
 */

import { itemByKey, placeMenu, oneTabStop } from '../ui/controls/navigation.ts';
import { byId, element, icon } from '../ui/dom.ts';
import { narrow } from '../viewport/camera.ts';
import type { Store } from '../store/state.ts';

/** Touch-sized buttons in a window that is too narrow for all of them. */
const TABLET = matchMedia('(pointer: coarse) and (min-width: 700px) and (max-width: 1099px)');
/** Groups of the toolbar that move to the bottom bar of a phone, and to the menu; others stay. */
const IN_BAR = ['group-run', 'group-file'];
const IN_MORE = {
  phone: ['group-mode', 'group-scene', 'group-page'],
  tablet: ['group-scene', 'group-page'],
};

export function arrangeForWidth(store: Store) {
  const header = byId('header');
  const groups = [...header.querySelectorAll('.group')];
  const tools = element('div', { id: 'tools', role: 'toolbar', 'aria-label': 'Tools' });
  const bar = byId('phone-bar');
  const more = byId('more');
  const moreButton = element(
    'button',
    { popovertarget: 'more' },
    icon('more'),
    element('span', 'More'),
  );
  header.append(tools);

  function arrange() {
    tools.append(...groups);
    if (narrow.matches) bar.append(...IN_BAR.map(byId), moreButton);
    else if (TABLET.matches) tools.append(moreButton);
    else moreButton.remove();
    if (!moreButton.isConnected) return;
    more.append(...IN_MORE[narrow.matches ? 'phone' : 'tablet'].map(byId));
    // In a menu each control is its own tab stop.
    for (const control of more.querySelectorAll('[tabindex]')) control.removeAttribute('tabindex');
  }
  for (const query of [narrow, TABLET]) query.addEventListener('change', arrange);
  arrange();
  [tools, bar, byId('select-bar')].forEach(oneTabStop);
  more.addEventListener('click', (event) => {
    const inside = event.target instanceof Element && event.target.closest('button');
    if (inside && !inside.hasAttribute('popovertarget')) more.hidePopover();
  });
  byId('examples').addEventListener('click', () => more.hidePopover());
  tabs(store);
  const unlessInMenu = (id: string) => () => (moreButton.isConnected ? moreButton : byId(id));
  placeMenu(byId('examples'), unlessInMenu('examples-button'));
  placeMenu(byId('recent'), unlessInMenu('recent-button'));
  byId('recent').addEventListener('click', () => more.hidePopover());
  placeMenu(more, () => moreButton);
}

/**
 * Tabs of the model and the inspector, which share one area. On a phone, the current tab also opens
 * and closes the sheet.
 */
function tabs(store: Store) {
  const { dataset } = document.body;
  const names = ['model', 'inspector'] as const;
  const buttons = names.map((name) => byId(`tab-${name}`));
  const show = (tab: (typeof names)[number]) => {
    const same = store.get().tab === tab;
    dataset.sheet = same && dataset.sheet === 'open' ? 'closed' : 'open';
    store.set({ tab });
    update();
  };
  function update() {
    const { tab } = store.get();
    dataset.tab = tab;
    const open = !narrow.matches || dataset.sheet === 'open';
    buttons.forEach((button, i) => {
      const isShown = names[i] === tab;
      button.setAttribute('aria-selected', String(isShown && open));
      button.tabIndex = isShown ? 0 : -1;
    });
  }
  narrow.addEventListener('change', update);
  store.subscribe(['tab'], update);
  buttons.forEach((button, i) => {
    button.addEventListener('click', () => show(names[i]));
    button.addEventListener('keydown', (event) => {
      const next = itemByKey(event, buttons, { along: 'x' });
      next?.focus();
      next?.click();
    });
  });
}
