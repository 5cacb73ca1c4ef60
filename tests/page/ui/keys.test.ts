// How keys are named.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  chordOf,
  digitOf,
  keyInTitle,
  keyName,
  singleKeys,
  workingKey,
} from '../../../www/ui/keys.ts';

test('letter keys are identified by character, digit keys by position', () => {
  const press = (key: string, more: Partial<KeyboardEvent> = {}) => {
    const held = { ctrlKey: false, shiftKey: false, metaKey: false };
    return { key, code: '', ...held, ...more } as KeyboardEvent;
  };
  assert.equal(chordOf(press('z', { ctrlKey: true })), 'Ctrl+Z');
  assert.equal(chordOf(press('Z', { metaKey: true, shiftKey: true })), 'Ctrl+Shift+Z');
  // The character already implies Shift.
  assert.equal(chordOf(press('?', { shiftKey: true })), '?');
  assert.equal(digitOf(press('&', { code: 'Digit1' })), '1');
  assert.equal(digitOf(press('!', { code: 'Digit1', shiftKey: true })), 'Shift+1');
  assert.equal(digitOf(press('7', { code: 'Numpad7' })), 'Numpad7');
  assert.equal(digitOf(press('Home', { code: 'Numpad7' })), '');
  assert.equal(keyName('Ctrl+Shift+Z'), 'Ctrl+Shift+Z');
  assert.equal(keyName(' '), 'Space');
});

test('a key that is switched off is not named', () => {
  assert.equal(workingKey('?', 'F1'), '?');
  assert.equal(keyInTitle('Shift+H', 'Delete'), ' (Shift+H)');
  singleKeys.set(false);
  try {
    assert.equal(workingKey('?', 'F1'), 'F1');
    assert.equal(workingKey('5', 'Numpad5'), '');
    assert.deepEqual(
      [' ', 'Ctrl+S', 'Home'].map((key) => workingKey(key)),
      ['Space', 'Ctrl+S', 'Home'],
    );
    assert.equal(keyInTitle('H'), '');
  } finally {
    singleKeys.set(true);
  }
});
