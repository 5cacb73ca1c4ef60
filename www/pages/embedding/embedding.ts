/** An example page that drives two embedded views, as a page on any other site could. */

import { byId, setText } from '../../ui/dom.ts';
import { count, length } from '../../ui/format.ts';
import type { Answer, Asked, News, ViewState } from '../../features/embed/protocol.ts';

/** The unit of both meshes. */
const UNIT = 'm';
const { origin } = location;
const views = ['left', 'right'].map((id) => ({
  frame: byId<HTMLIFrameElement>(id),
  numbers: byId(`${id}-numbers`),
  isReady: false,
}));
const start: HTMLButtonElement = byId('start');
const run: HTMLButtonElement = byId('run');
const reset: HTMLButtonElement = byId('reset');
const together: HTMLInputElement = byId('together');
let calls = 0;

function call({ frame }: (typeof views)[number], asked: Asked) {
  calls += 1;
  const message = { shapeUp: 'call', id: calls, ...asked };
  // The view's origin, which differs from this page's if the page is copied elsewhere.
  frame.contentWindow?.postMessage(message, new URL(frame.src).origin);
}

const both = (name: 'start' | 'run' | 'reset') => views.forEach((view) => call(view, { name }));

start.addEventListener('click', () => both('start'));
run.addEventListener('click', () => both('run'));
reset.addEventListener('click', () => both('reset'));

addEventListener('message', ({ source, data }) => {
  const view = views.find(({ frame }) => frame.contentWindow === source);
  if (!view) return;
  // Browser extensions also post messages.
  const message = (data ?? {}) as News | Answer | { shapeUp: undefined };
  if (!message.shapeUp) return;
  if (message.shapeUp === 'answer') {
    if (message.error) setText(byId('said'), message.error);
  } else if (message.news === 'camera') {
    if (!together.checked) return;
    for (const other of views)
      if (other !== view) call(other, { name: 'camera', camera: message.camera });
  } else if (message.news !== 'waiting') {
    show(view, message.state);
    view.isReady = true;
    start.disabled = views.every(({ isReady }) => isReady);
    run.disabled = reset.disabled = !start.disabled;
  }
});

function show(
  { frame, numbers }: (typeof views)[number],
  { iteration, converged, planarity, circularity, moved }: ViewState,
) {
  const off = frame.dataset.panels === 'flat' ? planarity : circularity;
  const worst = off && `worst panel off by ${length(off.max_distance, UNIT)}`;
  const way = moved && `moved by up to ${length(moved.max, UNIT)}`;
  const when = `${count(iteration, 'iteration')}${converged ? ', at rest' : ''}`;
  setText(numbers, [when, worst, way].filter(Boolean).join(', '));
}

const site = new URL('./', location.href).href;
setText(
  byId('line'),
  `<iframe src="${site}embed.html?embed#example=fig-05-circular" title="Circular panels, in Shape-Up" width="720" height="480" loading="lazy" style="border: 0"></iframe>`,
);
setText(byId('origin'), origin);
