// What happens once.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inTurn, once, oneAtATime } from '../../../www/ui/once.ts';

test('a second press has no effect while the first one loads, and has one after it, also after a failure', async () => {
  const loaded: ((opened: string) => void)[] = [];
  const fail: ((why: Error) => void)[] = [];
  const open = oneAtATime(
    () =>
      new Promise<string>((done, refuse) => {
        loaded.push(done);
        fail.push(refuse);
      }),
  );
  const first = open();
  assert.equal(open(), undefined);
  loaded[0]('the dialog');
  assert.equal(await first, 'the dialog');

  const second = open();
  fail[1](new Error('not there'));
  await assert.rejects(second as Promise<string>, /not there/);
  void open();
  assert.equal(loaded.length, 3);
});

test('what could not be fetched is fetched at the next call, and then kept', async () => {
  // Goals on parts stayed unmeasured once the network was back.
  let calls = 0;
  const fetched = once(async () => {
    calls += 1;
    if (calls === 1) throw new Error('no network');
    return 'the worker';
  });
  await assert.rejects(fetched(), /no network/);
  assert.equal(await fetched(), 'the worker');
  assert.equal(await fetched(), 'the worker');
  assert.equal(calls, 2);
});

test('an action without a promise takes every press', () => {
  let radius = 1;
  const larger = oneAtATime((factor: number) => (radius *= factor));
  larger(2);
  assert.equal(larger(3), 6);
});

test('a second press on a toggle that is still loading closes what the first one opens', async () => {
  let isOpen = false;
  let load = () => {};
  const loaded = new Promise<void>((done) => (load = done));
  const toggle = inTurn(async () => {
    await loaded;
    isOpen = !isOpen;
  });
  const presses = [toggle(), toggle()];
  load();
  await presses[0];
  assert.equal(isOpen, true);
  await presses[1];
  assert.equal(isOpen, false);
  await toggle();
  assert.equal(isOpen, true);
});
