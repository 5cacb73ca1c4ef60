// A second file is read alike, whether it is chosen or dropped.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FIT, POSE, readSecondFile } from '../../../www/store/second-files.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';

/**
 * What is sent and said when this file is read, perhaps while another model is opened.
 * @param boundaries how the boundary is held before and after
 */
async function read(
  how: typeof FIT,
  isRefused: boolean,
  isReplaced = false,
  boundaries = ['off', 'off'],
) {
  const heard: unknown[] = [];
  const store = createStore();
  const hold = (boundary: string) =>
    store.set({ document: { settings: { boundary } } } as unknown as State);
  hold(boundaries[0]);
  const actions = {
    edit: async (edit: unknown) => {
      heard.push(edit);
      hold(boundaries[1]);
      return isRefused ? undefined : null;
    },
    setStatus: (words: string) => heard.push(words),
  };
  const replaced = new AbortController();
  const text = async () => {
    if (isReplaced) replaced.abort();
    return 'v 0 0 0';
  };
  const file = { name: 'ground.obj', text } as File;
  const app = { store, actions, files: { replaced: replaced.signal } };
  await readSecondFile(how, file, app as unknown as AppContext);
  return heard;
}

test('what a second file has changed is said, unless it is refused', async () => {
  const given = { name: 'ground.obj', text: 'v 0 0 0' };
  assert.deepEqual(await read(FIT, false), [{ fitTo: given }, 'Vertices stay near ground.obj']);
  assert.deepEqual(await read(POSE, false), [
    { takePose: given },
    'Shapes are taken from ground.obj',
  ]);
  assert.deepEqual(await read(FIT, true), [{ fitTo: given }]);
});

test('a boundary that is no longer held is told', async () => {
  // What was set was off without a word.
  const said = async (boundaries: string[]) => (await read(FIT, false, false, boundaries))[1];
  const near = 'Vertices stay near ground.obj';
  assert.equal(await said(['exact', 'off']), `${near}, and the boundary is free`);
  assert.equal(await said(['soft', 'soft']), near);
});

test('a second file is used for the model that it was chosen for, and no other', async () => {
  assert.deepEqual(await read(FIT, false, true), [
    'ground.obj was not used: another model was opened meanwhile.',
  ]);
});

test('a file that cannot be read from the disk is named', async () => {
  // Browsers say only why; of a large mesh that was all that was said.
  const text = () => Promise.reject(new Error('permission denied'));
  const file = { name: 'ground.obj', text } as unknown as File;
  await assert.rejects(
    readSecondFile(FIT, file, { files: {} } as AppContext),
    /^Error: ground\.obj could not be read from the disk \(permission denied\)\.$/,
  );
});
