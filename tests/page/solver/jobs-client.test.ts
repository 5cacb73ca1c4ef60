// The second worker: its start, jobs that are cancelled, and a worker that fails.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { JobsClient } from '../../../www/solver/jobs-client.ts';
import type { Call } from '../../../www/solver/remote.ts';

const tick = () => new Promise((done) => setImmediate(done));

/** A worker that answers when the test says so. */
class FakeWorker {
  static all: FakeWorker[] = [];
  posted: (Call | string)[] = [];
  isEnded = false;
  declare onmessage: (event: { data: object }) => void;

  constructor() {
    FakeWorker.all.push(this);
  }
  postMessage(message: Call | string) {
    this.posted.push(message);
  }
  terminate() {
    this.isEnded = true;
  }
  /** Answers the call after the module with this number. */
  answer(call: number, answer: object) {
    const { id } = this.posted[call] as Call;
    this.onmessage({ data: { id, ...answer } });
  }
}

function client() {
  FakeWorker.all = [];
  globalThis.Worker = FakeWorker as unknown as typeof Worker;
  const jobs = new JobsClient(Promise.resolve('module' as unknown as WebAssembly.Module));
  const busy: boolean[] = [];
  jobs.on('busy', (event) => busy.push(event.busy));
  return { jobs, busy };
}

test('the worker starts with the first call, and gets the module before it', async () => {
  const { jobs } = client();
  await tick();
  assert.equal(FakeWorker.all.length, 0);
  const calls = [jobs.ask.buildOffers(), jobs.of('variations').ask.variation(3)];
  await tick();
  const [worker] = FakeWorker.all;
  const [module, ...posted] = worker.posted;
  assert.equal(module, 'module');
  assert.deepEqual(
    posted.map((call) => [(call as Call).name, (call as Call).given]),
    [
      ['buildOffers', []],
      ['variation', [3]],
    ],
  );
  worker.answer(2, { refused: 'there is no such variation', isDead: false });
  worker.answer(1, { value: 'presets' });
  assert.equal(await calls[0], 'presets');
  await assert.rejects(calls[1], /no such variation/);
  assert.ok(!worker.isEnded, 'what is refused leaves the worker as it is');
});

test('a long job is told by its name', async (context) => {
  // Of all jobs it was said nothing, with no Cancel, while the card of new panels was open.
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const { jobs } = client();
  const names: string[] = [];
  jobs.on('busy', ({ job }) => names.push(job));
  void jobs.ask.buildOffers();
  void jobs
    .of('variations')
    .ask.variation(3)
    .catch(() => {});
  await tick();
  context.mock.timers.tick(1500);
  assert.deepEqual(names, ['buildOffers']);
});

test('a long job can be cancelled with those that wait, and the next has another worker', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const { jobs, busy } = client();
  const first = jobs.ask.buildOffers();
  await tick();
  mock.timers.tick(1499);
  assert.deepEqual(busy, []);
  mock.timers.tick(1);
  assert.deepEqual(busy, [true]);
  const second = jobs.ask.buildOffers();
  await tick();
  jobs.cancel();
  await assert.rejects(first, /^Error: Cancelled\.$/);
  await assert.rejects(second, /^Error: Cancelled\.$/);
  assert.deepEqual(busy, [true, false]);
  await tick();
  const [ended] = FakeWorker.all;
  assert.ok(ended.isEnded);
  const third = jobs.ask.buildOffers();
  await tick();
  // A late answer of the worker that was ended settles nothing.
  ended.answer(1, { value: 'late' });
  mock.timers.tick(1500);
  assert.deepEqual(busy, [true, false, true]);
  FakeWorker.all[1].answer(1, { value: 'presets' });
  assert.equal(await third, 'presets');
  assert.deepEqual(busy, [true, false, true, false]);
  mock.timers.reset();
});

test('what waits while another job is cancelled is told that, and what is of a copy is asked again', async () => {
  // The current job was asked again as well, and those that waited failed.
  const { jobs } = client();
  const model = { text: 'the scene', generation: 5 };
  const current = jobs.copy(model).forecast();
  const [waiting, ofCopy] = [jobs.ask.buildOffers(), jobs.copy(model).tryExact()];
  await tick();
  jobs.cancel();
  await assert.rejects(current, { isDirect: true });
  await assert.rejects(waiting, { isDirect: false });
  await tick();
  const [, worker] = FakeWorker.all;
  assert.deepEqual(
    worker.posted.slice(1).map((call) => (call as Call).name),
    ['tryExact'],
  );
  worker.answer(1, { value: true });
  assert.equal(await ofCopy, true);
});

test('a job can be cancelled by its name, whichever is the current one', async () => {
  const { jobs } = client();
  const current = jobs.ask.buildOffers();
  const named = jobs.of('variations').ask.variation(3);
  await tick();
  jobs.cancel('variation');
  await assert.rejects(current, { isDirect: false });
  await assert.rejects(named, { isDirect: true });
});

test('a call during the start of a worker that is cancelled is cancelled too', async () => {
  const { jobs } = client();
  const call = jobs.ask.buildOffers();
  jobs.cancel();
  await assert.rejects(call, /Cancelled/);
});

test('after a trap the other calls fail, and the next has another worker', async () => {
  const { jobs } = client();
  const calls = [jobs.of('trials').ask.advance(), jobs.ask.buildOffers()];
  await tick();
  const [worker] = FakeWorker.all;
  worker.answer(1, { refused: 'unreachable', isDead: true });
  for (const call of calls) await assert.rejects(call, /unreachable/);
  await tick();
  assert.ok(worker.isEnded);
  void jobs.ask.buildOffers();
  await tick();
  assert.equal(FakeWorker.all.length, 2);
});
