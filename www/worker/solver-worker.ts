/** The worker: owns the Solver and answers the calls of the page. The page decides. */

import init, { Solver } from '../pkg/engine/shape_up.js';
import { isTrap, messageOf } from '../solver/errors.ts';
import { fetchModule } from './fetch-wasm.ts';
import { changesOf, commandsOf, questionsOf } from './interface.ts';
import { answerIfReplaced } from './outdated.ts';
import { Scheduler } from './scheduler.ts';
import { resetIdle } from './warm-up.ts';
import type { FromWorker } from '../solver/events.ts';
import type { Call } from '../solver/remote.ts';

type Method = (...given: unknown[]) => unknown;

const OTHER_MESH = 'The mesh has changed meanwhile, and nothing was done. Try again.';

/** Calls received before the solver was ready. */
const early: Call[] = [];
onmessage = (event) => early.push(event.data);

try {
  const module = await fetchModule(post);
  await init({ module_or_path: module });
  listen(new Solver(), module);
} catch (thrown) {
  post({ type: 'died', message: messageOf(thrown) });
}

function post(message: FromWorker, transfer: Transferable[] = []) {
  postMessage(message, { transfer });
}

function listen(solver: Solver, module: WebAssembly.Module) {
  let isDead = false;
  const died = (thrown: unknown) => {
    isDead = true;
    scheduler.stop();
    post({ type: 'died', message: messageOf(thrown) });
  };
  const scheduler = new Scheduler(solver, post, died);
  const commands = commandsOf(scheduler) as Record<string, Method>;
  const own = { ...changesOf(solver, scheduler), ...questionsOf(solver, scheduler) };
  const answers = own as Record<string, Method>;
  const methods = solver as unknown as Record<string, Method>;
  const called = ({ name, given }: Call) =>
    name in answers ? answers[name](...given) : methods[name](...given);

  function answer(call: Call, id: number) {
    post({ type: 'working', id });
    try {
      post({ type: 'reply', id, value: called(call) });
    } catch (thrown) {
      if (isTrap(thrown)) died(thrown);
      const path = thrown instanceof Error && 'path' in thrown ? String(thrown.path) : '';
      post({ type: 'refused', id, message: messageOf(thrown), path });
    }
  }

  function receive(call: Call) {
    if (isDead) return;
    // Answered between slices, to show that the worker is alive.
    if (call.name === 'ping') return post({ type: 'pong' });
    resetIdle();
    const type = answerIfReplaced(call, scheduler.meshes);
    const { id } = call;
    if (id === undefined) {
      if (!type) scheduler.guard(() => commands[call.name](...call.given));
    } else if (type) post({ type, id, message: OTHER_MESH, path: '' });
    else answer(call, id);
  }

  post({
    type: 'ready',
    kinds: solver.kinds(),
    measures: solver.measures(),
    operations: solver.operations(),
    settings: solver.settings(),
    module,
  });
  onmessage = (event) => receive(event.data);
  early.forEach(receive);
}
