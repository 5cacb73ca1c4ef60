/** The embedded view's side of the protocol: executes calls of the parent page and posts news. */

import { messageOf } from '../../solver/messages.js';
import { declared } from '../../store/colours/measures.js';
import { callIn, post } from './protocol.js';

/** @param {import("../../app/context.js").AppContext} app */
export function answerMessages(app) {
  const { files, script, store } = app;
  // Camera moves by the parent page are not posted back.
  let placed = false;
  for (const name of ['pointerdown', 'wheel', 'keydown'])
    addEventListener(name, () => (placed = false), { capture: true, passive: true });

  addEventListener('message', async (event) => {
    const call = callIn(event);
    if (!call) return;
    const { id } = call;
    if (call.name === 'camera') placed = true;
    try {
      post({ shapeUp: 'answer', id, result: await answer(call, app) }, event.origin);
    } catch (error) {
      post({ shapeUp: 'answer', id, error: messageOf(error) }, event.origin);
    }
  });

  const tell = (/** @type {"ready" | "state"} */ news) =>
    post({ shapeUp: 'news', news, state: script.state() });
  files.on('opened', () => tell('ready'));
  store.subscribe(['numbers', 'document', 'running'], ({ document }) => {
    if (document) tell('state');
  });
  store.subscribe(['camera'], ({ camera }) => {
    if (camera && !placed) post({ shapeUp: 'news', news: 'camera', camera });
  });
  if (store.get().document) tell('ready');
}

/**
 * @param {import("./protocol.js").Call} call
 * @param {import("../../app/context.js").AppContext} app
 */
async function answer(call, app) {
  const { actions, script, store } = app;
  switch (call.name) {
    case 'start':
      return undefined;
    case 'open': {
      const { vertices, faces } = await script.open(call.text, call.as);
      return { vertices, faces };
    }
    case 'run':
      return actions.run();
    case 'pause':
      return store.get().running ? actions.runOrPause() : undefined;
    case 'step':
      return actions.step();
    case 'reset':
      return actions.reset();
    case 'weight':
      return edited(app, { type: 'setConstraint', index: call.constraint, weight: call.weight });
    case 'handle':
      return moveHandle(app, call.vertex, call.target);
    case 'measure':
      return colourBy(app, call.measure);
    case 'camera':
      return actions.look({ camera: call.camera });
    case 'state':
      return script.state();
    case 'scene':
      return script.scene();
    case 'positions':
      return script.positions();
    default: {
      const { name } = /** @type {{ name: unknown }} */ (call);
      throw new Error(`There is no call ${JSON.stringify(name)}: see embedding.html.`);
    }
  }
}

/**
 * Colours the faces; throws for a measure that does not exist.
 * @param {import("../../app/context.js").AppContext} app
 * @param {string | null} measure
 */
function colourBy({ actions, store }, measure) {
  const { measures } = store.get();
  if (measure !== null && !declared(store.get(), measure)) {
    const known = measures.map(({ id }) => id).join(', ');
    throw new Error(`There is no measure ${JSON.stringify(measure)}, expected null or ${known}.`);
  }
  return actions.colourBy(measure);
}

/**
 * Edits the scene; rejects with the reason of a refusal, which the page would show instead.
 * @param {import("../../app/context.js").AppContext} app
 * @param {import("../../solver/messages.js").Edit} edit
 */
async function edited({ actions }, edit) {
  /** @type {unknown} */
  let refused;
  const done = await actions.edit(edit, (error) => {
    refused = error;
    return true;
  });
  if (done === undefined) throw refused;
}

/**
 * @param {import("../../app/context.js").AppContext} app
 * @param {number} vertex
 * @param {number[]} target
 */
async function moveHandle(app, vertex, target) {
  const handles = app.store.get().document?.handles ?? [];
  if (!handles.some((handle) => handle.vertex === vertex))
    await edited(app, { type: 'addHandles', vertices: [vertex], fixed: false });
  const handle = { vertex, target: /** @type {[number, number, number]} */ ([...target]) };
  for (const phase of /** @type {const} */ (['start', 'move', 'end']))
    app.actions.moveHandles([handle], phase);
}
