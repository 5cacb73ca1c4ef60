/** An example page that drives two embedded views, as a page on any other site could. */

import { byId, setText } from '../../ui/dom.js';
import { count, length } from '../../ui/format.js';

/** @typedef {import("../../features/embed/protocol.js").News} News */
/** @typedef {import("../../features/embed/protocol.js").Answer} Answer */

/** The unit of both meshes. */
const UNIT = 'm';
const { origin } = location;
const views = ['left', 'right'].map((id) => ({
  frame: /** @type {HTMLIFrameElement} */ (byId(id)),
  numbers: byId(`${id}-numbers`),
  isReady: false,
}));
/** @type {HTMLButtonElement} */
const start = byId('start');
/** @type {HTMLButtonElement} */
const run = byId('run');
/** @type {HTMLButtonElement} */
const reset = byId('reset');
/** @type {HTMLInputElement} */
const together = byId('together');
let calls = 0;

/**
 * @param {typeof views[number]} view
 * @param {import("../../features/embed/protocol.js").Asked} asked
 */
function call({ frame }, asked) {
  calls += 1;
  const message = { shapeUp: 'call', id: calls, ...asked };
  // The view's origin, which differs from this page's if the page is copied elsewhere.
  frame.contentWindow?.postMessage(message, new URL(frame.src).origin);
}

/** @param {"start" | "run" | "reset"} name */
const both = (name) => views.forEach((view) => call(view, { name }));

start.addEventListener('click', () => both('start'));
run.addEventListener('click', () => both('run'));
reset.addEventListener('click', () => both('reset'));

addEventListener('message', ({ source, data }) => {
  const view = views.find(({ frame }) => frame.contentWindow === source);
  if (!view) return;
  // Browser extensions also post messages.
  const message = /** @type {News | Answer | { shapeUp: undefined }} */ (data ?? {});
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

/**
 * @param {typeof views[number]} view
 * @param {import("../../features/embed/protocol.js").ViewState} state
 */
function show({ frame, numbers }, { iteration, converged, planarity, circularity, moved }) {
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
