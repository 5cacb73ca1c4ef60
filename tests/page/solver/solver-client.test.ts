// Which scene a new worker opens after work was cancelled, the generations of the shape, and which mesh
// a call is about.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { Cancelled, wasCollateral } from '../../../www/solver/errors.ts';
import { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Call } from '../../../www/solver/remote.ts';
import type { Opening } from '../../../www/worker/open.ts';

const tick = () => new Promise((done) => setTimeout(done));

/** A worker that says what the test tells it to say. */
class FakeWorker {
  declare static latest: FakeWorker;
  posted: Call[] = [];
  /** Set by the client. */
  declare onmessage: (event: { data: object }) => void;

  constructor() {
    FakeWorker.latest = this;
  }
  postMessage(message: Call) {
    this.posted.push(message);
  }
  terminate() {}
  say(message: object) {
    this.onmessage({ data: message });
  }
  model(name: string, mesh: number = 1, guessed: object = {}) {
    this.say({
      ...{ type: 'model', mesh, loaded: { name, guessed }, connectivity: {} },
      positions: new Float64Array(3),
    });
  }
  scene(text: string, iteration: number) {
    this.say({ type: 'scene', text, iteration, history: null });
  }
  /** Answers the request to open a file. */
  opened(undoLost: string = '') {
    const { id } = this.#opening;
    this.say({ type: 'reply', id, value: { undoLost } });
  }
  /** The number of the mesh that the last call is about. */
  get mesh() {
    return this.posted.at(-1)?.mesh;
  }
  get reopened() {
    const [{ files }] = this.#opening.given as [Opening];
    return new TextDecoder().decode(files[0].bytes);
  }
  /** The request to open a file. */
  get #opening() {
    const request = this.posted.find((message) => message.name === 'open');
    assert.ok(request);
    return request;
  }
}

/** Opens roof.obj. */
async function clientWithRoof() {
  const client = new SolverClient();
  const worker = FakeWorker.latest;
  const opened = client.change.open({ files: [] });
  worker.say({ type: 'ready' });
  worker.model('roof.obj');
  worker.scene('the roof', 7);
  worker.opened();
  await opened;
  worker.posted.length = 0;
  return client;
}

globalThis.Worker = FakeWorker as unknown as typeof Worker;
// Node does not exit while the client watches its worker.
mock.method(globalThis, 'setInterval', () => 0);

test('a file whose opening is cancelled before its answer does not replace the scene', async () => {
  const client = await clientWithRoof();
  const names: string[] = [];
  client.on('model', ({ loaded }) => names.push(loaded.name));
  const refused = assert.rejects(client.change.open({ files: [] }));
  FakeWorker.latest.model('large.obj');
  FakeWorker.latest.scene('the large mesh', 0);
  client.abandon();
  await refused;
  // The cancelled file used to be restored.
  assert.equal(client.sceneText, 'the roof');
  assert.equal(client.saved.iteration, 7);
  FakeWorker.latest.say({ type: 'ready' });
  assert.equal(FakeWorker.latest.reopened, 'the roof');
  FakeWorker.latest.model('restored.shapeup.json');
  assert.deepEqual(names, ['large.obj', 'roof.obj']);
});

test('what was guessed of a file stays a guess when its mesh is changed or restored', async () => {
  // It was then told as stated by the file, and the question about it was gone.
  const client = await clientWithRoof();
  const guesses: object[] = [];
  client.on('model', ({ loaded }) => guesses.push(loaded.guessed));
  const opened = client.change.open({ files: [] });
  const guessed = { units: 'm', up: null };
  FakeWorker.latest.model('dome.stl', 2, guessed);
  FakeWorker.latest.scene('the dome', 0);
  FakeWorker.latest.opened();
  await opened;
  FakeWorker.latest.model('', 3);
  client.abandon();
  FakeWorker.latest.say({ type: 'ready' });
  FakeWorker.latest.model('restored.shapeup.json');
  assert.deepEqual(guesses, [guessed, guessed, guessed]);
});

test('progress is saved beside the scene that it continues, and not beside a newer one', async () => {
  const client = await clientWithRoof();
  const bytes = new Uint8Array(1);
  FakeWorker.latest.say({ type: 'progress', bytes, iteration: 9 });
  assert.equal(client.saved.progress, bytes);
  FakeWorker.latest.scene('the edited roof', 10);
  assert.deepEqual(client.saved, { iteration: 10, history: null, progress: null });
});

test('work cancelled while the scene is being restored restores it without a notice', async () => {
  const client = await clientWithRoof();
  const events: string[] = [];
  client.on('restarted', ({ message }) => events.push(message));
  client.on('model', ({ loaded }) => events.push(`${loaded.name}, ${client.restoring}`));
  for (let time = 0; time < 2; time++) {
    client.abandon();
    await tick();
    FakeWorker.latest.say({ type: 'ready' });
  }
  FakeWorker.latest.model('restored.shapeup.json');
  FakeWorker.latest.scene('the roof', 7);
  FakeWorker.latest.opened();
  await tick();
  // The first restoring used to report that the scene could not be reopened, and the model then
  // counted as another one, called restored.shapeup.json.
  assert.deepEqual(events, ['roof.obj, true']);
});

test('every other mesh and every other shape is another generation, other frames are not', async () => {
  const client = await clientWithRoof();
  const generation = () => client.geometry?.generation ?? 0;
  const generations: number[] = [];
  const say = (type: 'frame' | 'model', ...positions: number[]) => {
    const loaded = { name: 'roof.obj' };
    FakeWorker.latest.say({
      ...{ type, loaded, connectivity: {}, positions: Float64Array.from(positions) },
      numbers: { stepMs: 1 },
    });
    generations.push(generation());
  };
  const first = generation();
  // The same sums of coordinates, another measure of the same shape, another mesh of it.
  say('frame', 0, 1, 2);
  say('frame', 2, 1, 0);
  say('frame', 2, 1, 0);
  say('model', 2, 1, 0);
  say('frame', 2, 1, 0);
  assert.deepEqual(
    generations.map((each) => each - first),
    [1, 2, 2, 3, 3],
  );
});

test('a call is about the mesh that the page shows, and cancelled if that has been replaced', async () => {
  const client = await clientWithRoof();
  const worker = FakeWorker.latest;
  const edited = client.change.edit('reset');
  assert.equal(worker.mesh, 1);
  worker.say({ type: 'outdated', id: worker.posted[0].id });
  await assert.rejects(edited, Cancelled);
  worker.model('', 2);
  void client.change.edit('reset');
  assert.equal(worker.mesh, 2);
});

test('a buffer goes back to the mesh that it is of, and not to a new worker', async () => {
  // After an edit that kept the number of vertices there were three buffers instead of two.
  const client = await clientWithRoof();
  const worker = FakeWorker.latest;
  const frame = () => {
    const positions = new Float64Array(3);
    worker.say({ type: 'frame', positions, numbers: { stepMs: 1 } });
  };
  worker.model('', 2);
  frame();
  client.recycle();
  assert.deepEqual([worker.posted.at(-1)?.name, worker.mesh], ['recycle', 2]);
  frame();
  client.abandon();
  FakeWorker.latest.say({ type: 'ready' });
  client.recycle();
  assert.ok(!FakeWorker.latest.posted.some(({ name }) => name === 'recycle'));
});

test('what is edited while the model comes back is edited then, but no other model', async () => {
  const client = await clientWithRoof();
  const edit = () => client.change.edit('reset').catch(() => {});
  FakeWorker.latest.model('', 7);
  FakeWorker.latest.scene('the roof', 8);
  client.abandon();
  FakeWorker.latest.say({ type: 'ready' });
  void edit();
  // It is the first one of the new worker.
  assert.equal(FakeWorker.latest.mesh, 1);
  FakeWorker.latest.model('roof.obj', 1);
  FakeWorker.latest.scene('the roof', 8);
  FakeWorker.latest.opened();
  await tick();
  client.change.open({ files: [] }).catch(() => {});
  FakeWorker.latest.model('large.obj', 2);
  client.abandon();
  FakeWorker.latest.say({ type: 'ready' });
  void edit();
  assert.equal(FakeWorker.latest.mesh, 0);
});

test('what waits behind cancelled work is done by the next worker, but nothing that the user has cancelled', async () => {
  // A change was dropped without a word, though only the long work before it was cancelled. An undo would
  // have taken that back; a scene that is restored is restored by the next worker anyway.
  const client = await clientWithRoof();
  const { ask, change } = client;
  const waiting = () => [
    ...[change.open({ files: [] }), change.edit('reset'), ask.scene()],
    ...[change.undo(), change.makePanels('circle', 1, 'now')],
  ];
  /** @param work the place of the call at work; none of a run */
  const after = async (work?: number) => {
    const ended = waiting().map((each) => each.catch((error: Error) => wasCollateral(error)));
    const worker = FakeWorker.latest;
    const ids = worker.posted.flatMap(({ id }) => id ?? []).slice(-ended.length);
    worker.say({ type: 'working', id: work === undefined ? work : ids[work] });
    // Its first part is the end of the run.
    worker.say({ type: 'working' });
    client.abandon();
    await tick();
    FakeWorker.latest.say({ type: 'ready' });
    const names = FakeWorker.latest.posted.map(({ name }) => name);
    return { names, of: (place: number) => ended[place] };
  };
  const behindRun = await after();
  assert.deepEqual(behindRun.names, ['open', 'edit', 'scene', 'makePanels']);
  assert.deepEqual([await behindRun.of(0), await behindRun.of(3)], [true, true]);
  const behindOpening = await after(0);
  assert.deepEqual(behindOpening.names.slice(0, 4), ['open', 'edit', 'scene', 'makePanels']);
  assert.equal(await behindOpening.of(0), false);
});

test('work that the user cancels is no error', async () => {
  // It was said that the solver had stopped.
  const client = await clientWithRoof();
  const edited = client.change.edit('reset');
  client.abandon();
  await assert.rejects(edited, (error) => error instanceof Cancelled && !wasCollateral(error));
});

test('an undo history that is lost by cancelling is told', async () => {
  const client = await clientWithRoof();
  const told: string[] = [];
  client.on('restarted', ({ message }) => told.push(message));
  client.abandon();
  FakeWorker.latest.say({ type: 'ready' });
  FakeWorker.latest.model('restored.shapeup.json');
  FakeWorker.latest.opened('it is of another version');
  await tick();
  assert.equal(told.length, 1);
  assert.match(told[0], /its undo history is lost: it is of another version/);
});
