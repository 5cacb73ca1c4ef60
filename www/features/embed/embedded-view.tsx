/**
 * The bar of an embedded view, and its input: the view handles wheel and touch only while it has
 * the focus, so that the user can scroll the page around it past the view.
 *
 * Options in the address after `?embed`, whose value is `PRESSED` if the user started the view:
 *
 * | option | meaning |
 * |---|---|
 * | `autoplay` | starts the view at once and iterates |
 * | `panel=model` | shows the steps |
 * | `measure=ID` | colours the faces by a measure; `none` is the plain material |
 * | `theme=light`, `theme=dark` | overrides the system's theme |
 */

import './embedded-view.css';
import { useSignal } from '@preact/signals';
import { useLayoutEffect } from 'preact/hooks';
import { linkTo, pageAddress } from '../../documents/share-link.ts';
import { useApp } from '../../store/use-app.ts';
import { Button, Icon } from '../../ui/components/buttons.tsx';
import { byId } from '../../ui/dom.ts';
import { PRESSED } from '../../ui/embedded.ts';

/** How long it is said after a turn of the wheel that the view has to be clicked, in milliseconds. */
const HINT_MS = 1200;

export function EmbeddedView() {
  const app = useApp();
  const { store, actions, files } = app;
  const { running, document: scene, example, fileName } = store.state;
  const isHinted = useSignal(false);
  const address = useSignal(pageAddress() + location.hash);

  useLayoutEffect(() => {
    const asked = new URLSearchParams(location.search);
    document.documentElement.dataset.panel = asked.get('panel') ?? '';
    files.on('opened', () => {
      const measure = asked.get('measure');
      if (measure) actions.colourBy(measure === 'none' ? null : measure);
      if (asked.has('autoplay')) actions.run();
    });
    handOverInput(byId('viewport'), asked.get('embed') === PRESSED, (isIdle) => {
      isHinted.value = isIdle;
    });
  }, []);

  /** Updates the link to the current state. */
  async function refresh() {
    if (scene) address.value = (await linkTo(app)).address;
  }

  return (
    <>
      <p id="embed-hint" hidden={!isHinted.value}>
        Click the view to zoom
      </p>
      <footer id="embed-bar" aria-label="Embedded view">
        <Button class="primary" disabled={!scene} onClick={() => actions.runOrPause()}>
          <Icon name={running ? 'pause' : 'run'} />
          <span>{running ? 'Pause' : 'Run'}</span>
        </Button>
        <button type="button" disabled={!scene} onClick={() => actions.reset()}>
          <Icon name="reset" />
          Reset
        </button>
        <p class="title">{example?.title ?? fileName}</p>
        <a
          href={address.value}
          target="_blank"
          rel="noopener"
          onPointerEnter={refresh}
          onFocus={refresh}
        >
          Open in Shape-Up
        </a>
      </footer>
    </>
  );
}

/**
 * The view handles wheel and touch from a press in it until it loses the focus; otherwise the page
 * around it does.
 * @param isPressed whether the view was started by a press
 * @param hint called with whether the wheel was turned over the view, which left it to the page
 */
function handOverInput(view: HTMLElement, isPressed: boolean, hint: (isIdle: boolean) => void) {
  let isActive = isPressed;
  const activate = (isNow: boolean) => {
    isActive = isNow;
    view.dataset.active = String(isActive);
    hint(false);
  };
  activate(isPressed);
  for (const name of ['pointerdown', 'keydown']) addEventListener(name, () => activate(true), true);
  addEventListener('blur', () => activate(false));
  let fading: ReturnType<typeof setTimeout> | undefined;
  view.addEventListener(
    'wheel',
    (event) => {
      if (isActive) return;
      event.stopImmediatePropagation();
      hint(true);
      clearTimeout(fading);
      fading = setTimeout(() => hint(false), HINT_MS);
    },
    { capture: true, passive: true },
  );
}
