/**
 * The part of the layout for narrow windows that style sheets cannot do: moving the groups of the
 * toolbar.
 */

import { placeMenu, oneTabStop } from '../ui/controls/navigation.ts';
import { byId, element, icon } from '../ui/dom.ts';
import { narrow } from '../viewport/camera.ts';

/** Groups of the toolbar that move to the bottom bar of a phone, and to its menu; others stay. */
const IN_BAR = ['group-run'];
const IN_MORE = ['group-mode', 'group-page'];

export function arrangeForWidth() {
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
    moreButton.remove();
    if (!narrow.matches) return;
    bar.append(...IN_BAR.map(byId), moreButton);
    more.append(...IN_MORE.map(byId));
    // In a menu each control is its own tab stop.
    for (const control of more.querySelectorAll('[tabindex]')) control.removeAttribute('tabindex');
  }
  narrow.addEventListener('change', arrange);
  arrange();
  [tools, bar, byId('select-bar')].forEach(oneTabStop);
  more.addEventListener('click', (event) => {
    const inside = event.target instanceof Element && event.target.closest('button');
    if (inside) more.hidePopover();
  });
  placeMenu(more, () => moreButton);
}
