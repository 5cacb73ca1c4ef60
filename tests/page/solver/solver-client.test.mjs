// Which scene a new worker opens after work was cancelled.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { SolverClient } from '../../../www/solver/solver-client.js';

const tick = () => new Promise((done) => setTimeout(done));

/** A worker that says what the test tells it to say. */
class FakeWorker {
  static latest = /** @type {any} */ (null);
  posted = [];

  constructor() {
    FakeWorker.latest = this;
  }
  postMessage(message) {
    this.posted.push(message);
  }
  terminate() {}
  say(message) {
    this.onmessage({ data: message });
  }
  model(name) {
    this.say({
      ...{ type: 'model', loaded: { name }, connectivity: {} },
      positions: new Float64Array(3),
    });
  }
  scene(text, iteration) {
    this.say({ type: 'scene', text, iteration, history: null });
  }
  /** Answers the request to open a file. */
  opened() {
    const { id } = this.posted.find(({ type }) => type === 'open');
    this.say({ type: 'reply', id, value: { undoLost: '' } });
  }
  get reopened() {
    const { files } = this.posted.find(({ type }) => type === 'open');
    return new TextDecoder().decode(files[0].bytes);
  }
}

/** Opens roof.obj. */
async function clientWithRoof() {
  const client = new SolverClient();
  const worker = FakeWorker.latest;
  const opened = client.request({ type: 'open', files: [] });
  worker.say({ type: 'ready' });
  worker.model('roof.obj');
  worker.scene('the roof', 7);
  worker.opened();
  await opened;
  worker.posted.length = 0;
  return client;
}

globalThis.Worker = /** @type {any} */ (FakeWorker);
// Node does not exit while the client watches its worker.
mock.method(globalThis, 'setInterval', () => 0);

test('a file whose opening is cancelled before its answer does not replace the scene', async () => {
  const client = await clientWithRoof();
  const names = [];
  client.on('model', ({ loaded }) => names.push(loaded.name));
  const refused = assert.rejects(client.request({ type: 'open', files: [] }));
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
  const events = [];
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
