// A second file is read alike, whether it is chosen or dropped.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FIT, POSE, readSecondFile } from '../../../www/store/second-files.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** What is sent and said when this file is read, perhaps while another model is opened. */
async function read(how: typeof FIT, isRefused: boolean, isReplaced = false) {
  const heard: unknown[] = [];
  const actions = {
    edit: async (edit: unknown) => (heard.push(edit), isRefused ? undefined : null),
    setStatus: (words: string) => heard.push(words),
  };
  const replaced = new AbortController();
  const text = async () => {
    if (isReplaced) replaced.abort();
    return 'v 0 0 0';
  };
  const file = { name: 'ground.obj', text } as File;
  await readSecondFile(how, file, actions as unknown as Actions, replaced.signal);
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
    readSecondFile(FIT, file, {} as Actions, new AbortController().signal),
    /^Error: ground\.obj could not be read from the disk \(permission denied\)\.$/,
  );
});
