// Only one request runs at a time, and then the latest one.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { latestOnly, newestOnly } from '../../../www/store/latest-only.ts';

/** A request that has not been answered yet. */
interface Asked {
  question: string;
  answer: () => void;
  fail: (error: Error) => void;
}

/** Requests are answered when the test does so. */
function held() {
  const asked: Asked[] = [];
  const questions = latestOnly(
    (question: string) =>
      new Promise<void>((answer, fail) => asked.push({ question, answer, fail })),
  );
  return { asked, questions };
}

const turn = () => new Promise((done) => setTimeout(done));
const names = (asked: Asked[]) => asked.map(({ question }) => question);

test('outdated requests are dropped', async () => {
  const { asked, questions } = held();
  const first = questions.ask('a');
  void questions.ask('b');
  void questions.ask('c');
  assert.deepEqual(names(asked), ['a']);
  assert.equal(questions.hasNext(), true);
  asked[0].answer();
  await turn();
  assert.deepEqual(names(asked), ['a', 'c']);
  assert.equal(questions.hasNext(), false);
  assert.equal(questions.isBusy(), true);
  asked[1].answer();
  await first;
  assert.equal(questions.isBusy(), false);
});

test('after a failed request, later requests are answered', async () => {
  const { asked, questions } = held();
  const first = questions.ask('a');
  asked[0].fail(new Error('no network'));
  await assert.rejects(first, /no network/);
  void questions.ask('b');
  assert.deepEqual(names(asked), ['a', 'b']);
});

test('a waiting request is answered although the one before fails', async () => {
  const { asked, questions } = held();
  const first = questions.ask('a');
  void questions.ask('b');
  asked[0].fail(new Error('no network'));
  await turn();
  assert.deepEqual(names(asked), ['a', 'b']);
  asked[1].answer();
  await assert.rejects(first, /no network/);
});

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
