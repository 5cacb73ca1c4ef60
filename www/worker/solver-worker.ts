/** The worker: owns the Solver and handles the messages of `messages.ts`. The page decides. */

import init, { Solver } from '../pkg/engine/shape_up.js';
import { messageOf, type ToWorker, type Request, type FromWorker } from '../solver/messages.ts';
import { fetchModule } from './fetch-wasm.ts';
import { commandHandlers, requestHandlers } from './handlers.ts';
import { Scheduler } from './scheduler.ts';
import { stopTrials } from './trials.ts';
import { resetIdle } from './warm-up.ts';
import { isTrap } from './wasm-errors.ts';

type Command = Exclude<import('../solver/messages.ts').Command, { type: 'ping' }>;

/** Messages that make pending trials useless. */
const CHANGES: Set<ToWorker['type']> = new Set([
  ...(['run', 'drag', 'open', 'edit', 'editAndRun', 'makePanels'] as ToWorker['type'][]),
  ...(['undo', 'redo', 'step', 'halfStep'] as ToWorker['type'][]),
]);

/** Messages received before the solver was ready. */
const early: ToWorker[] = [];
onmessage = (event) => early.push(event.data);

try {
  await init({ module_or_path: fetchModule(post) });
  listen(new Solver());
} catch (thrown) {
  post({ type: 'died', message: messageOf(thrown) });
}

function post(message: FromWorker, transfer: Transferable[] = []) {
  postMessage(message, { transfer });
}

function listen(solver: Solver) {
  let isDead = false;
  const died = (thrown: unknown) => {
    isDead = true;
    scheduler.stop();
    post({ type: 'died', message: messageOf(thrown) });
  };
  const scheduler = new Scheduler(solver, post, died);
  const commands = commandHandlers(scheduler);
  const requests = requestHandlers(solver, scheduler, post);

  const command = <C extends Command>(message: C) => {
    const handler = commands[message.type] as (message: C) => void;
    scheduler.guard(() => handler(message));
  };

  function request<R extends Request>(message: R & { id: number }) {
    const { id } = message;
    post({ type: 'working' });
    const refuse = (thrown: unknown) => {
      if (isTrap(thrown)) died(thrown);
      const path = thrown instanceof Error && 'path' in thrown ? String(thrown.path) : '';
      post({ type: 'refused', id, message: messageOf(thrown), path });
    };
    try {
      const handler = requests[message.type] as (message: R) => unknown;
      const value = handler(message);
      if (!(value instanceof Promise)) return post({ type: 'reply', id, value });
      value.then((value) => post({ type: 'reply', id, value }), refuse);
      // The request continues in slices.
      post({ type: 'pong' });
    } catch (thrown) {
      refuse(thrown);
    }
  }

  function receive(message: ToWorker) {
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
