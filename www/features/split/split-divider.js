/** The divider between two pictures: dragged, or moved by keys. */

import { element } from '../../ui/dom.js';

/** Arrow keys move by so much of the width, page keys by more. */
const STEP = 0.01;
const LEAP = 0.1;
/** @type {Record<string, number>} */
const STEPS = {
  ArrowLeft: -STEP,
  ArrowDown: -STEP,
  ArrowRight: STEP,
  ArrowUp: STEP,
  PageDown: -LEAP,
  PageUp: LEAP,
  Home: -1,
  End: 1,
};

/**
 * @param {import("../../app/context.js").AppContext} app
 * @param {() => string[] | undefined} words what is left and right
 */
export function splitDivider({ store, actions }, words) {
  const divider = element(
    'div.split-divider',
    {
      role: 'slider',
      tabindex: '0',
      'aria-label': 'Divider',
      'aria-orientation': 'horizontal',
      'aria-valuemin': '0',
      'aria-valuemax': '100',
    },
    element('span.knob'),
  );

  /** @param {number} at */
  function moveTo(at) {
    const { split } = store.get();
    if (split) actions.look({ split: { ...split, at: Math.min(Math.max(at, 0), 1) } });
  }

  const listen = /** @type {HTMLElement["addEventListener"]} */ (
    divider.addEventListener.bind(divider)
  );
  /** From the pointer to the line, in pixels, while it is dragged. @type {number | null} */
  let grabbed = null;
  listen('pointerdown', (event) => {
    const { left, width } = divider.getBoundingClientRect();
    grabbed = left + width / 2 - event.clientX;
    divider.setPointerCapture(event.pointerId);
    divider.focus({ preventScroll: true });
    event.preventDefault();
  });
  listen('pointermove', (event) => {
    const area = divider.offsetParent?.getBoundingClientRect();
    if (grabbed === null || !area) return;
    moveTo((event.clientX + grabbed - area.left) / area.width);
  });
  for (const type of /** @type {const} */ (['pointerup', 'pointercancel']))
    listen(type, () => (grabbed = null));
  listen('dblclick', () => moveTo(0.5));
  listen('keydown', (event) => {
    const step = STEPS[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    moveTo(Math.round(100 * ((store.get().split?.at ?? 0) + step)) / 100);
  });

  store.subscribe(['split'], ({ split }) => {
    divider.hidden = !split;
    if (!split) return;
    const percent = Math.round(100 * split.at);
    divider.style.left = `${100 * split.at}%`;
    divider.setAttribute('aria-valuenow', String(percent));
    const [left, right] = words() ?? [];
    divider.setAttribute('aria-valuetext', `${percent} %; left ${left}; right ${right}`);
  });
  return divider;
}
