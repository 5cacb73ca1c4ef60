// What Undo is said to take back.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { undone } from '../../../www/store/undone.ts';
import type { State } from '../../../www/store/state.ts';

const model = {} as State['model'];
const after = (undo: string | null) => ({ undo }) as State['document'];
const idle = { document: after('Add plane'), model, undoes: '', running: false, press: null };

test('during a run Undo takes back the run, also where there is no step before it', () => {
  assert.equal(undone(idle), 'Add plane');
  assert.equal(undone({ ...idle, running: true }), 'Run');
  assert.equal(undone({ ...idle, document: after(null) }), '');
  assert.equal(undone({ ...idle, document: after(null), running: true }), 'Run');
  assert.equal(undone({ ...idle, undoes: 'New mesh', document: after(null) }), 'New mesh');
});

test('the run of a press for all panels is a part of its step', () => {
  const press = { model, isUnderWay: true, label: '' } as State['press'];
  const made = { ...idle, document: after('Make panels flat'), running: true };
  assert.equal(undone({ ...made, press }), 'Make panels flat');
  // That of another model is over.
  assert.equal(undone({ ...made, press, model: { ...model } as State['model'] }), 'Run');
});
