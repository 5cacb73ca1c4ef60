// Which of several openings wins, whatever order their files arrive in.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Openings, type Opening } from '../../../www/documents/openings.ts';

/** Openings whose files arrive when the test says so. */
function slowly() {
  const openings = new Openings();
  /** What was opened, in order. */
  const opened: string[] = [];
  const begin = (name: string) => {
    let arrive = () => {};
    let fail: (error: Error) => void = () => {};
    const file = new Promise<void>((done, refuse) => ([arrive, fail] = [done, refuse]));
    const done = openings.begin(async (opening: Opening) => {
      await file;
      if (!(await opening.isWanted())) return null;
      opened.push(name);
      opening.opened();
      return name;
    });
    return { arrive, fail, done };
  };
  return { openings, opened, begin };
}

test('a later opening wins although the file of an earlier one arrives after it', async () => {
  const { openings, opened, begin } = slowly();
  const [example, own] = [begin('example'), begin('own')];
  assert.ok(openings.coming);
  own.arrive();
  assert.equal(await own.done, 'own');
  example.arrive();
  assert.equal(await example.done, null);
  assert.deepEqual(opened, ['own']);
  assert.equal(openings.coming, null);
});

test('an earlier opening waits for a later one, and opens if that is refused', async () => {
  const { opened, begin } = slowly();
  const [example, own] = [begin('example'), begin('own')];
  example.arrive();
  await new Promise((done) => setTimeout(done));
  assert.deepEqual(opened, []);
  own.fail(new Error('it is no mesh'));
  await assert.rejects(own.done, /it is no mesh/);
  assert.equal(await example.done, 'example');
  assert.deepEqual(opened, ['example']);
});

test('the failure of an earlier opening is dropped once a later one has opened its model', async () => {
  const { opened, begin } = slowly();
  const [example, own] = [begin('example'), begin('own')];
  example.fail(new Error('no network'));
  own.arrive();
  assert.equal(await example.done, null);
  assert.deepEqual(opened, ['own']);
});

test('an opening is told when a later one has opened its model, not when an earlier one has', async () => {
  const openings = new Openings();
  const opened: Opening[] = [];
  const ends: (() => void)[] = [];
  for (let count = 0; count < 3; count++)
    void openings.begin((opening) => {
      opened.push(opening);
      return new Promise<void>((end) => ends.push(end));
    });
  opened[1].opened();
  assert.deepEqual(
    opened.map(({ overtaken }) => overtaken.aborted),
    [true, false, false],
  );
  ends.forEach((end) => end());
});

test('a model is not coming while the user is asked whether to open it', async () => {
  // Panels of the open model were not made, as if they were meant for the other one.
  const openings = new Openings();
  let answer = () => {};
  let ended = () => {};
  const done = openings.begin(async ({ asks }) => {
    await asks(new Promise<void>((yes) => (answer = yes)));
    await new Promise<void>((end) => (ended = end));
  });
  assert.equal(openings.coming, null);
  answer();
  await new Promise((later) => setTimeout(later));
  assert.ok(openings.coming);
  ended();
  await done;
});

test('messages are cleared as an opening begins, never later', async () => {
  // A refused link's message was lost when the first example, begun before it, came after it.
  let cleared = 0;
  const openings = new Openings(() => (cleared += 1));
  let arrive = () => {};
  const example = openings.begin(() => new Promise<void>((done) => (arrive = done)));
  const link = openings.begin(() => Promise.reject(new Error('truncated')));
  await assert.rejects(link, /truncated/);
  assert.equal(cleared, 2);
  arrive();
  await example;
  assert.equal(cleared, 2);
});
