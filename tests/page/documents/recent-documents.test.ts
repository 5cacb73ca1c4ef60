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
  removals,
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

test('a file opened again and again pushes out no work that was changed', async (context) => {
  // Eight copies of it were all that was left.
  const removed: string[] = [];
  context.after(removals.on('beyond', (titles) => removed.push(...titles)));
  await keep(work('edited roof'), contents('hours of work'));
  for (let time = 1; time <= 9; time++) {
    await keep({ ...work(`copy-${time}`), file: 'of the file' }, contents('a model'));
    await pruneOldest();
  }
  assert.deepEqual(await ids(), ['copy-9', 'edited roof']);
  for (let time = 1; time <= 8; time++) {
    await keep({ ...work(`file-${time}`), file: `of file ${time}` }, contents('a model'));
    await pruneOldest();
  }
  assert.ok((await ids()).includes('edited roof'));
  assert.deepEqual(removed, []);
  // What was changed is told when it has to go.
  for (let time = 1; time <= 8; time++) {
    await keep(work(`edited-${time}`), contents('a model'));
    await pruneOldest();
  }
  assert.deepEqual(removed, ['edited roof']);
});

test('what a link has brought is kept like changed work, but once', async () => {
  // It went before all others, as if it could be opened again from a file.
  await keep({ ...work('linked'), hash: '#link=abc', file: 'of the link' }, contents('a model'));
  await keep({ ...work('again'), hash: '#link=abc', file: 'of the link' }, contents('a model'));
  for (let opened = 1; opened <= 7; opened++) await keep(work(`edited-${opened}`), contents('it'));
  for (let opened = 1; opened <= 9; opened++)
    await keep({ ...work(`copy-${opened}`), file: `of file ${opened}` }, contents('a model'));
  await pruneOldest();
  const left = await ids();
  assert.equal(left.length, 8);
  assert.deepEqual([left.includes('again'), left.includes('linked')], [true, false]);
});

test('a work for which there is no room leaves the others', async (context) => {
  for (const id of ['older', 'newer']) await keep(work(id), contents('1234'));
  context.mock.method(records, 'set', () => {
    throw new DOMException('Full.', 'QuotaExceededError');
  });
  await assert.rejects(keep(work('new'), contents('1')), { name: 'QuotaExceededError' });
  assert.deepEqual(await ids(), ['newer', 'older']);
});

test('a damaged fallback copy holds up no other', async () => {
  storeUnsaved(work('first'), contents('a model'));
  const [key] = Object.keys(window.localStorage);
  window.localStorage.setItem(`${key} damaged`, '{"work":');
  storeUnsaved(work('second'), contents('a model'));
  await recoverUnsaved();
  assert.deepEqual((await ids()).sort(), ['first', 'second']);
  assert.deepEqual(Object.keys(window.localStorage), []);
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

test('works of links that were only looked at push out no work that was changed', async () => {
  // A teacher who looked at eight links lost works of her own.
  for (const own of ['one', 'two']) await keep(work(own), contents('hours of work'));
  for (let k = 1; k <= 8; k++) {
    const [hash, file] = [`#link=${k}`, `of link ${k}`];
    await keep({ ...work(`linked-${k}`), hash, file }, contents('a model'));
    await pruneOldest();
  }
  const left = await ids();
  assert.equal(left.length, 8);
  assert.ok(left.includes('one') && left.includes('two'), left.join());
});
