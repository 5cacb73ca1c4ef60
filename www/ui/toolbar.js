/**
 * Bars of controls are one stop of the Tab key each: the arrow keys walk within them, Home and End
 * go to their ends, and the stop is where somebody was last.
 */

const CONTROLS = 'button, input, select';
/** Of a slider only these; the others set it. */
const WAYS = { ArrowLeft: -1, ArrowRight: 1 };

/** @param {HTMLElement} bar with `role="toolbar"` */
export function oneTabStop(bar) {
  /** @type {HTMLElement | null} */
  let stop = null;
  const all = () => /** @type {HTMLButtonElement[]} */ ([...bar.querySelectorAll(CONTROLS)]);
  const reachable = () => all().filter((control) => !control.disabled && control.checkVisibility());

  function update() {
    const controls = reachable();
    const focused = controls.find((control) => control === document.activeElement);
    const last = controls.find((control) => control === stop);
    stop = focused ?? last ?? controls[0] ?? null;
    for (const control of all()) control.tabIndex = control === stop ? 0 : -1;
  }

  bar.addEventListener('focusin', update);
  bar.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    const controls = reachable();
    const at = controls.findIndex((control) => control === event.target);
    const way = WAYS[/** @type {keyof typeof WAYS} */ (event.key)];
    const isSlider = controls[at]?.matches('[type="range"]');
    const end = isSlider ? undefined : { Home: 0, End: controls.length - 1 }[event.key];
    if (at < 0 || (way === undefined && end === undefined)) return;
    event.preventDefault();
    controls[end ?? (at + way + controls.length) % controls.length].focus();
  });
  // What has the stop may go, or come back.
  const watch = { subtree: true, childList: true, attributeFilter: ['disabled', 'hidden'] };
  new MutationObserver(update).observe(bar, watch);
  new ResizeObserver(update).observe(bar);
  update();
}
