/** The embedded view's side of the protocol: executes calls of the parent page and posts news. */

import { messageOf, type Edit } from '../../solver/messages.ts';
import { declared } from '../../store/colours/measures.ts';
import { callIn, post, type Call } from './protocol.ts';
import type { AppContext } from '../../app/context.ts';

export function answerMessages(app: AppContext) {
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

  const tell = (news: 'ready' | 'state') => post({ shapeUp: 'news', news, state: script.state() });
  files.on('opened', () => tell('ready'));
  store.subscribe(['numbers', 'document', 'running'], ({ document }) => {
    if (document) tell('state');
  });
  store.subscribe(['camera'], ({ camera }) => {
    if (camera && !placed) post({ shapeUp: 'news', news: 'camera', camera });
  });
  if (store.get().document) tell('ready');
}

async function answer(call: Call, app: AppContext) {
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
      const { name } = call as { name: unknown };
      throw new Error(`There is no call ${JSON.stringify(name)}: see embedding.html.`);
    }
  }
}

/** Colours the faces; throws for a measure that does not exist. */
function colourBy({ actions, store }: AppContext, measure: string | null) {
  const { measures } = store.get();
  if (measure !== null && !declared(store.get(), measure)) {
    const known = measures.map(({ id }) => id).join(', ');
    throw new Error(`There is no measure ${JSON.stringify(measure)}, expected null or ${known}.`);
  }
  return actions.colourBy(measure);
}

/** Edits the scene; rejects with the reason of a refusal, which the page would show instead. */
async function edited({ actions }: AppContext, edit: Edit) {
  let refused: unknown;
  const done = await actions.edit(edit, (error) => {
    refused = error;
    return true;
  });
  if (done === undefined) throw refused;
}

async function moveHandle(app: AppContext, vertex: number, target: number[]) {
  const handles = app.store.get().document?.handles ?? [];
  if (!handles.some((handle) => handle.vertex === vertex))
    await edited(app, { type: 'addHandles', vertices: [vertex], fixed: false });
  const handle = { vertex, target: [...target] as [number, number, number] };
  for (const phase of ['start', 'move', 'end'] as const) app.actions.moveHandles([handle], phase);
}
