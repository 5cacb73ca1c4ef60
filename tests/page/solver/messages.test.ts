// Shared by page and worker: events, and the choice of the file to open.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { filesNamed, mainOf, worthReading } from '../../../www/solver/opened-files.ts';
import type { NamedBytes } from '../../../www/solver/messages.ts';

test('listeners are called in order, a one-time listener only once, and one that throws does not affect the others', () => {
  const reported: string[] = [];
  globalThis.reportError = (error) => reported.push(error.message);
  const emitter = new Emitter<{ frame: number }>();
  const heard: [string, number][] = [];
  emitter.on('frame', () => {
    throw new Error('broken');
  });
  const stop = emitter.on('frame', (value) => heard.push(['on', value]));
  emitter.once('frame', (value) => heard.push(['once', value]));
  emitter.emit('frame', 1);
  emitter.emit('frame', 2);
  stop();
  emitter.emit('frame', 3);
  assert.deepEqual(heard, [
    ['on', 1],
    ['once', 1],
    ['on', 2],
  ]);
  assert.equal(reported.length, 3);
});

test('a scene is opened with the mesh that it names, else the first readable file', () => {
  const file = (name: string) => ({ name, bytes: new Uint8Array() });
  const [scene, mesh, words] = ['roof.shapeup.json', 'roof.obj', 'notes.txt'].map(file);
  assert.equal(mainOf([mesh, scene]), scene);
  assert.deepEqual(worthReading([words, mesh, scene]), [scene, mesh]);
  assert.deepEqual(worthReading([words]), [words]);
  const named = (files: NamedBytes[]) => filesNamed(files, () => ['models/roof.obj', 'other.obj']);
  assert.deepEqual(named([scene, mesh]), [
    { path: 'models/roof.obj', file: mesh },
    { path: 'other.obj', file: undefined },
  ]);
  assert.deepEqual(named([mesh]), []);
});
