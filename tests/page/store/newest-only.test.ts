// Answers that are out of date are dropped.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { newestOnly } from '../../../www/store/newest-only.ts';

const later = <Value>(value: Value) => new Promise<Value>((done) => setTimeout(done, 2, value));
const failing = () => later(0).then(() => Promise.reject(new Error('refused')));

test('the answer to an earlier question is dropped, whichever arrives first, and so is its error', async () => {
  const newest = newestOnly();
  const answers = [newest(later('a')), newest(failing()), newest('c')];
  assert.deepEqual(await Promise.all(answers), [undefined, undefined, 'c']);
});

test('an answer about something that was replaced is dropped', async () => {
  let model = 'roof';
  const newest = newestOnly(() => model);
  const about = newest(later(1));
  model = 'tower';
  assert.equal(await about, undefined);
  assert.equal(await newest(later(2)), 2);
});

test('an error of the newest question is passed on', async () => {
  await assert.rejects(newestOnly()(failing()), /refused/);
});
