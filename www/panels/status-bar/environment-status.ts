/** The environment in the status bar: offline, software rendering. */

import { element } from '../../ui/dom.ts';
import { isDrawn } from '../../store/state.ts';
import type { AppContext } from '../../app/context.ts';
import type { Actions } from '../../store/actions.ts';

/** Names of software renderers. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const SLOW = 'Software rendering is slow. Turn on graphics acceleration in the browser settings.';

/** @param numbers the list of the status bar */
export function environmentStatus(numbers: HTMLElement, { store, actions }: AppContext) {
  const offline = element('div', { hidden: true }, element('dd', 'Offline'));
  const software = element(
    'div.wide.narrow-hidden',
    { title: SLOW, hidden: true },
    element('dd', 'Software rendering'),
  );
  numbers.append(software, offline);
  networkStatus(offline, actions);
  store.subscribe(['renderer'], (state) => {
    software.hidden = !(isDrawn(state) && drawsInSoftware());
  });
}

/** Shows that the browser is offline, while it is. */
function networkStatus(place: HTMLElement, actions: Actions) {
  const update = () => {
    const offline = !navigator.onLine;
    if (offline === !place.hidden) return;
    const kept = Boolean(navigator.serviceWorker?.controller);
    const words = `Offline: ${kept ? 'everything still works' : 'what is loaded still works'}`;
    place.hidden = !offline;
    place.title = words;
    actions.setStatus(offline ? words : 'Online again');
  };
  window.addEventListener('online', update);
  window.addEventListener('offline', update);
  update();
}

/** Whether WebGL is rendered in software. */
function drawsInSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = names && context?.getParameter(names.UNMASKED_RENDERER_WEBGL);
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(String(name));
}
