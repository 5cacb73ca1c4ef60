// Only one request runs at a time, and then the latest one.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { latestOnly } from '../../../www/store/latest-only.ts';

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
