// Shared by page and worker: events, the choice of the file to open, and the words of errors.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { messageOf, refusalOf } from '../../../www/solver/errors.ts';
import { filesNamed, mainOf, worthReading } from '../../../www/solver/opened-files.ts';
import type { NamedBytes } from '../../../www/solver/types.ts';

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

test('one file is not taken for two that a scene names by the same name in two folders', () => {
  // The vertices were kept near the mesh itself.
  const file = (name: string) => ({ name, bytes: new Uint8Array() });
  const given = [file('roof.shapeup.json'), file('mesh.obj')];
  const named = (...paths: string[]) => filesNamed(given, () => paths);
  assert.throws(
    () => named('roof/mesh.obj', 'surface/mesh.obj'),
    /^Error: roof\/mesh\.obj and surface\/mesh\.obj have the same name here/,
  );
  assert.equal(named('mesh.obj', './mesh.obj').length, 2);
  assert.equal(named('a/other.obj', 'b/other.obj').length, 2);
});

test('what could not be fetched is said in plain words', () => {
  const words = 'A part of the page could not be fetched. Check the network.';
  for (const message of [
    'Failed to fetch dynamically imported module: http://localhost/assets/help-1234567.js',
    'error loading dynamically imported module: http://localhost/assets/help-1234567.js',
    'Importing a module script failed.',
    'Failed to fetch',
    'NetworkError when attempting to fetch resource.',
    'Load failed',
    'WebAssembly compilation aborted: Network error: Response body loading was aborted',
  ])
    assert.equal(messageOf(new TypeError(message)), words, message);
  for (const message of [
    'Unable to preload CSS for /assets/help-1234567.css',
    "failed to fetch Wasm: 404 Not Found fetching 'http://localhost/assets/engine-1234567.wasm'",
  ])
    assert.equal(messageOf(new Error(message)), words, message);
});

test('an error about a file keeps its words, whatever the file is called', () => {
  for (const message of [
    'imported module.obj, line 3: expected a number, found "x"',
    'Failed to fetch.obj, line 1: nothing here is known',
    'Failed to fetch',
    'Load failed',
    'roof.obj, line 2: expected a number, found "Failed to fetch"',
    'The file "preload CSS.off" ends in line 7.',
    'failed to fetch Wasm: no number in line 2',
  ]) {
    assert.equal(messageOf(new Error(message)), message);
    assert.equal(messageOf(message), message);
  }
  assert.equal(messageOf(new TypeError('x is not a function')), 'x is not a function');
});

test('a refusal has the reason of the engine, and is none of the network', () => {
  // New panels were said to be not possible without a network.
  const reason = new Error('there are no faces');
  assert.equal(refusalOf(reason, 'Not possible'), 'Not possible: there are no faces.');
  const lost = new TypeError('Failed to fetch');
  assert.equal(refusalOf(lost, 'Not possible'), messageOf(lost));
});
