// A second file is read alike, whether it is chosen or dropped.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FIT, POSE, readSecondFile } from '../../../www/store/second-files.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** What is sent and said when this file is read. */
async function read(how: typeof FIT, isRefused: boolean) {
  const heard: unknown[] = [];
  const actions = {
    edit: async (edit: unknown) => (heard.push(edit), isRefused ? undefined : null),
    setStatus: (words: string) => heard.push(words),
  };
  const file = { name: 'ground.obj', text: async () => 'v 0 0 0' };
  await readSecondFile(how, file as File, actions as unknown as Actions);
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
