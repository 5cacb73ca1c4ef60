/**
 * The bar of an embedded view, and its input: the view handles wheel and touch only while it has
 * the focus, so that the user can scroll the page around it past the view.
 *
 * Options in the address after `?embed`, whose value is `PRESSED` if the user started the view:
 *
 * | option | meaning |
 * |---|---|
 * | `autoplay` | starts the view at once and iterates |
 * | `panel=model` | shows the steps; so does `inspector`, of older links |
 * | `measure=ID` | colours the faces by a measure; `none` is the plain material |
 * | `theme=light`, `theme=dark` | overrides the system's theme |
 */

import './embedded-view.css';
import { byId, element, icon, setText } from '../../ui/dom.ts';
import { linkTo } from '../../documents/share-link.ts';
import { PRESSED } from '../../ui/embedded.ts';
import type { AppContext } from '../../app/context.ts';

export function embeddedView(app: AppContext) {
  const asked = new URLSearchParams(location.search);
  document.documentElement.dataset.panel = asked.get('panel') ?? '';
  document.body.append(bar(app));
  takeTurns(byId('viewport'), asked.get('embed') === PRESSED);
  app.files.on('opened', () => {
    const measure = asked.get('measure');
    if (measure) app.actions.colourBy(measure === 'none' ? null : measure);
    if (asked.has('autoplay')) app.actions.run();
  });
}

function bar(app: AppContext) {
  const { actions, store } = app;
  const runs = element('span', 'Run');
  const run = element('button.primary', { onclick: () => actions.runOrPause() }, icon('run'), runs);
  const reset = element('button', { onclick: () => actions.reset() }, icon('reset'), 'Reset');
  const title = element('p.title');
  const home = element(
    'a',
    {
      href: `./${location.hash}`,
      target: '_blank',
      rel: 'noopener',
      onpointerenter: refresh,
      onfocus: refresh,
    },
    'Open in Shape-Up',
  );
  /** Updates the link to the current state. */
  async function refresh() {
    if (store.get().document) home.href = (await linkTo(app)).address;
  }
  store.subscribe(['running', 'document'], ({ running, document }) => {
    setText(runs, running ? 'Pause' : 'Run');
    run.querySelector('use')?.setAttribute('href', running ? '#icon-pause' : '#icon-run');
    run.disabled = reset.disabled = !document;
  });
  store.subscribe(['example', 'fileName'], ({ example, fileName }) =>
    setText(title, example?.title ?? fileName),
  );
  return element(
    'footer',
    { id: 'embed-bar', 'aria-label': 'Embedded view' },
    run,
    reset,
    title,
    home,
  );
}

/**
 * The view handles wheel and touch from a press in it until it loses the focus; otherwise the page
 * around it does.
 * @param isPressed whether the view was started by a press
 */
function takeTurns(view: HTMLElement, isPressed: boolean) {
  const hint = element('p', { id: 'embed-hint', hidden: true }, 'Click the view to zoom');
  byId('main').append(hint);
  const activate = (isActive: boolean) => {
    view.dataset.active = String(isActive);
    hint.hidden = true;
  };
  activate(isPressed);
  for (const name of ['pointerdown', 'keydown']) addEventListener(name, () => activate(true), true);
  addEventListener('blur', () => activate(false));
  let fading: ReturnType<typeof setTimeout> | undefined;
  view.addEventListener(
    'wheel',
    (event) => {
      if (view.dataset.active === 'true') return;
      event.stopImmediatePropagation();
      hint.hidden = false;
      clearTimeout(fading);
      fading = setTimeout(() => (hint.hidden = true), 1200);
    },
    { capture: true, passive: true },
  );
}
