// Which saved works stay in the database, and what the fallback copy of a closed page changes.

import assert from 'node:assert/strict';
import { beforeEach, test, type TestContext } from 'node:test';
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

/** Limits the database to so many characters of scenes. */
function limit(context: TestContext, room: number) {
  const set = Map.prototype.set.bind(records);
  context.mock.method(records, 'set', (key: string, value: unknown) => {
    const others = [...records].filter(([other]) => other !== key);
    const texts = [...others, [key, value]].map(([, one]) => (typeof one === 'string' ? one : ''));
    if (texts.join('').length > room) throw new DOMException('Full.', 'QuotaExceededError');
    return set(key, value);
  });
}

test('a full database loses the oldest works that no tab has open, and says which', async (context) => {
  // It used to lose all of them, and nothing was said.
  const removed: string[] = [];
  context.after(removals.on('removed', (titles) => removed.push(...titles)));
  locks.add(`${LOCK_PREFIX}other-tab`);
  for (const id of ['other-tab', 'oldest', 'older', 'newer'])
    await keep(work(id), contents('1234'));
  limit(context, 17);
  await keep(work('new'), contents('567890'));
  assert.deepEqual(await ids(), ['new', 'newer', 'other-tab']);
  assert.deepEqual(removed, ['oldest', 'older']);
});

test('a work that does not fit even without the others leaves them', async (context) => {
  const removed: string[] = [];
  context.after(removals.on('removed', (titles) => removed.push(...titles)));
  const history = Uint8Array.of(7);
  for (const id of ['older', 'newer']) await keep(work(id), { ...contents('1234'), history });
  limit(context, 10);
  const large = { ...work('large'), savedAt: 0 };
  const put = () => keep(large, contents('12345678901'));
  await assert.rejects(put, { name: 'QuotaExceededError' });
  assert.deepEqual(await ids(), ['newer', 'older']);
  assert.deepEqual(await contentsOf('older'), {
    ...contents('1234'),
    history,
    progress: undefined,
  });
  assert.deepEqual(removed, []);
  // The next save of it does not try again.
  const gone = context.mock.method(records, 'delete');
  await assert.rejects(put);
  assert.equal(gone.mock.callCount(), 0);
});

test('a write that fails while room is made removes no work', async (context) => {
  // Each removed work was written again, which failed too, or never came to it: the page was closed.
  for (const id of ['older', 'newer']) await keep(work(id), contents('1234'));
  const lost: string[] = [];
  context.mock.method(records, 'set', () => {
    throw new DOMException('Full.', 'QuotaExceededError');
  });
  const query = context.mock.method(navigator.locks, 'query', async () => {
    if (records.size < 4) lost.push('while it is tried');
    return { held: [] };
  });
  await assert.rejects(keep(work('new'), contents('1')), { name: 'QuotaExceededError' });
  assert.deepEqual(await ids(), ['newer', 'older']);
  assert.ok(query.mock.callCount() > 1);
  assert.deepEqual(lost, []);
});

test('a work that another tab opens while room is made stays', async (context) => {
  for (const id of ['older', 'newer']) await keep(work(id), contents('1234'));
  limit(context, 8);
  const { query } = navigator.locks;
  let attempts = 0;
  context.mock.method(navigator.locks, 'query', () => {
    if (++attempts === 2) locks.add(`${LOCK_PREFIX}newer`);
    return query();
  });
  await assert.rejects(keep(work('new'), contents('12345678')), { name: 'QuotaExceededError' });
  assert.deepEqual(await ids(), ['newer', 'older']);
});

test('a work that did not fit is tried again once others can make room', async (context) => {
  // It was not, even if there had been none to remove.
  locks.add(`${LOCK_PREFIX}other-tab`);
  await keep(work('other-tab'), contents('1234'));
  limit(context, 4);
  const put = () => keep({ ...work('again'), savedAt: 0 }, contents('12'));
  await assert.rejects(put);
  await assert.rejects(put);
  locks.clear();
  await put();
  assert.deepEqual(await ids(), ['again']);
});

test('a work whose writing failed for another reason is tried again', async (context) => {
  await keep(work('older'), contents('1234'));
  const set = Map.prototype.set.bind(records);
  let isBroken = true;
  context.mock.method(records, 'set', (key: string, value: unknown) => {
    if (records.has('text older')) throw new DOMException('Full.', 'QuotaExceededError');
    if (isBroken) throw new DOMException('Broken.', 'UnknownError');
    return set(key, value);
  });
  const put = () => keep(work('new'), contents('12'));
  await assert.rejects(put, { name: 'UnknownError' });
  isBroken = false;
  await put();
  assert.deepEqual(await ids(), ['new']);
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
