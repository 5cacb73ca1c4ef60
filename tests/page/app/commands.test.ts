// What a key does: for how long it is held, and where the focus is.

import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { bindKeys } from '../../../www/app/commands.ts';
import { createStore } from '../../../www/store/state.ts';
import type { Command } from '../../../www/app/context.ts';

/** A field in which text is typed. */
const FIELD = { matches: (what: string) => what.startsWith('textarea') };

/** Commands with these keys, and what presses of keys did. */
function bound(
  context: TestContext,
  commands: Partial<Command>[],
  { dialog = false, focus = null }: { dialog?: boolean; focus?: object | null } = {},
) {
  let listen: (event: object) => void = () => {};
  const before = ['window', 'document', 'HTMLElement', 'HTMLInputElement', 'HTMLTextAreaElement'];
  context.after(() => before.forEach((name) => Reflect.deleteProperty(globalThis, name)));
  Object.assign(globalThis, {
    window: { addEventListener: (_: string, heard: typeof listen) => (listen = heard) },
    document: { querySelector: () => (dialog ? {} : null), activeElement: focus },
    HTMLElement: class {},
    HTMLInputElement: class {},
    HTMLTextAreaElement: class {},
  });
  const done: string[] = [];
  const all = commands.map(({ keys = [], ...rest }) => ({
    ...{ id: keys[0], group: '', label: '', keys, action: () => done.push(keys[0]), ...rest },
  }));
  bindKeys(all, createStore(), async () => {});
  /** Returns whether the browser's own action is prevented. */
  const press = (key: string, held: Partial<KeyboardEvent> = {}) => {
    let isPrevented = false;
    listen({ key, code: '', preventDefault: () => (isPrevented = true), ...held });
    return isPrevented;
  };
  return { done, press };
}

test('a key that is held repeats a step, and no switch', (context) => {
  // Run and Pause used to follow each other.
  const { done, press } = bound(context, [{ keys: [' '] }, { keys: ['.'], repeats: true }]);
  for (const key of [' ', '.']) {
    assert.ok(press(key));
    assert.ok(press(key, { repeat: true }), 'the page does not scroll either');
  }
  assert.deepEqual(done, [' ', '.', '.']);
});

const SHORTCUTS = [{ keys: ['Ctrl+S'] }, { keys: ['Ctrl+Z'] }, { keys: ['F1'] }, { keys: ['W'] }];

test('over the page a dialog keeps its keys, and the browser its own from it', (context) => {
  // Ctrl+S in a dialog saved the page of the browser.
  const { done, press } = bound(context, SHORTCUTS, { dialog: true });
  assert.ok(press('s', { ctrlKey: true }));
  assert.ok(press('F1'));
  assert.ok(!press('w'));
  assert.ok(!press('p', { ctrlKey: true }), 'of no command');
  assert.deepEqual(done, []);
});

test('what changes text goes to the field of a dialog', (context) => {
  const { done, press } = bound(context, SHORTCUTS, { dialog: true, focus: FIELD });
  assert.ok(!press('z', { ctrlKey: true }));
  assert.ok(press('s', { ctrlKey: true }));
  assert.deepEqual(done, []);
});
