/** The worker: owns the Solver and handles the messages of `messages.js`. The page decides. */

import init, { Solver } from '../pkg/engine/shape_up.js';
import { messageOf } from '../solver/messages.js';
import { fetchModule } from './fetch-wasm.js';
import { commandHandlers, requestHandlers } from './handlers.js';
import { Scheduler } from './scheduler.js';
import { stopTrials } from './trials.js';
import { resetIdle } from './warm-up.js';
import { isTrap } from './wasm-errors.js';

/** @typedef {import("../solver/messages.js").ToWorker} ToWorker */
/** @typedef {import("../solver/messages.js").Request} Request */
/** @typedef {Exclude<import("../solver/messages.js").Command, { type: "ping" }>} Command */

/** Messages that make pending trials useless. @type {Set<ToWorker["type"]>} */
const CHANGES = new Set([
  .../** @type {ToWorker["type"][]} */ ([
    'run',
    'drag',
    'open',
    'edit',
    'editAndRun',
    'makePanels',
  ]),
  .../** @type {ToWorker["type"][]} */ (['undo', 'redo', 'step', 'halfStep']),
]);

/** Messages received before the solver was ready. @type {ToWorker[]} */
const early = [];
onmessage = (event) => early.push(event.data);

try {
  await init({ module_or_path: fetchModule(post) });
  listen(new Solver());
} catch (thrown) {
  post({ type: 'died', message: messageOf(thrown) });
}

/**
 * @param {import("../solver/messages.js").FromWorker} message
 * @param {Transferable[]} [transfer]
 */
function post(message, transfer = []) {
  postMessage(message, { transfer });
}

/** @param {Solver} solver */
function listen(solver) {
  let isDead = false;
  const died = (/** @type {unknown} */ thrown) => {
    isDead = true;
    scheduler.stop();
    post({ type: 'died', message: messageOf(thrown) });
  };
  const scheduler = new Scheduler(solver, post, died);
  const commands = commandHandlers(scheduler);
  const requests = requestHandlers(solver, scheduler, post, died);

  /**
   * @template {Command} C
   * @param {C} message
   */
  const command = (message) => {
    const handler = /** @type {(message: C) => void} */ (commands[message.type]);
    scheduler.guard(() => handler(message));
  };

  /**
   * @template {Request} R
   * @param {R & { id: number }} message
   */
  function request(message) {
    const { id } = message;
    post({ type: 'working' });
    const refuse = (/** @type {unknown} */ thrown) => {
      if (isTrap(thrown)) died(thrown);
      const path = thrown instanceof Error && 'path' in thrown ? String(thrown.path) : '';
      post({ type: 'refused', id, message: messageOf(thrown), path });
    };
    try {
      const handler = /** @type {(message: R) => unknown} */ (requests[message.type]);
      const value = handler(message);
      if (!(value instanceof Promise)) return post({ type: 'reply', id, value });
      value.then((value) => post({ type: 'reply', id, value }), refuse);
      // The request continues in slices.
      post({ type: 'pong' });
    } catch (thrown) {
      refuse(thrown);
    }
  }

  /** @param {ToWorker} message */
  function receive(message) {
    if (isDead) return;
    // Answered between slices, to show that the worker is alive.
    if (message.type === 'ping') return post({ type: 'pong' });
    resetIdle();
    if (CHANGES.has(message.type)) stopTrials();
    if ('id' in message) request(message);
    else command(message);
  }

  post({
    type: 'ready',
    kinds: solver.kinds(),
    elements: solver.elements(),
    measures: solver.measures(),
    operations: solver.operations(),
    settings: solver.settings(),
  });
  onmessage = (event) => receive(event.data);
  early.forEach(receive);
}
