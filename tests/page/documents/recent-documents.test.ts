// Which saved works stay in the database, and what the fallback copy of a closed page changes.

import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { locks, records } from './storage.ts';
import { recoverUnsaved, storeUnsaved } from '../../../www/documents/recent-documents.ts';
import {
  LOCK_PREFIX,
  contentsOf,
  keep,
  pruneOldest,
  recentDocuments,
  type Contents,
} from '../../../www/documents/recent-documents.ts';

let time = 0;
const work = (id: string) => ({
  ...{ id, name: id, title: id, savedAt: ++time, iteration: 0 },
  ...{ example: null, hash: '', view: null },
});
const contents = (text: string) => ({ text, history: null, progress: null });
const ids = async () => (await recentDocuments()).map(({ id }) => id);

beforeEach(() => {
  records.clear();
  locks.clear();
});

test('eight models opened in one tab leave the work that is open in another tab', async () => {
  // A tab used to know only which works it had open itself.
  locks.add(`${LOCK_PREFIX}other-tab`);
  await keep(work('other-tab'), contents('hours of work'));
  await keep(work('closed'), contents('a model'));
  for (let opened = 1; opened <= 9; opened++) {
    await keep(work(`model-${opened}`), contents('a model'));
    await pruneOldest();
  }
  const newest = Array.from({ length: 8 }, (_, i) => `model-${9 - i}`);
  assert.deepEqual(await ids(), [...newest, 'other-tab']);
  assert.equal((await contentsOf('other-tab')).text, 'hours of work');
});

test('a full database loses only works that no tab has open', async (context) => {
  locks.add(`${LOCK_PREFIX}other-tab`);
  for (const id of ['other-tab', 'closed']) await keep(work(id), contents('a model'));
  const put = context.mock.method(records, 'set', function () {
    put.mock.restore();
    throw new DOMException('There is no room.', 'QuotaExceededError');
  });
  await keep(work('new'), contents('a model'));
  assert.deepEqual(await ids(), ['new', 'other-tab']);
});

test('the fallback copy leaves saved progress that is too long for it', async () => {
  const [saved, short, long] = [3, 4, 1_000_001].map((size) => new Uint8Array(size));
  const progressAfter = async (later: Partial<Contents>) => {
    await keep(work('run'), { ...contents('a large mesh'), progress: saved });
    storeUnsaved(work('run'), later);
    await recoverUnsaved();
    return (await contentsOf('run')).progress ?? null;
  };
  // It used to be deleted.
  assert.deepEqual(await progressAfter({ progress: long }), saved);
  assert.deepEqual(await progressAfter({ progress: short }), short);
  assert.equal(await progressAfter({ progress: null }), null);
  // Progress of an earlier scene does not fit another.
  assert.equal(await progressAfter({ text: 'another', history: null, progress: long }), null);
});
