// A story in browsers other than that of the page tests, where they can be had.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { at, program } from '../../.scripts/project.mjs';
import { serve } from '../../.scripts/serve.mjs';
import { firefox } from './firefox.mjs';
import { wavyGrid } from '../page/meshes.ts';
import { beginScreen, endAll, folderOfOwn, pathOf } from './programs.mjs';
import { positionsOf, tell } from './story.mjs';
import { webkit } from './webkit.mjs';

const { address, close } = await serve(at('dist'), { port: 0 });
test.after(close);

const SIDE = 8;
const folder = folderOfOwn({ 'grid.obj': wavyGrid(SIDE) });
const mesh = {
  path: join(folder, 'grid.obj'),
  vertices: (SIDE + 1) ** 2,
  held: 4 * (SIDE + 1) + 4,
};

/** The shape that the program finds for the same press. */
function expected() {
  const out = join(folder, 'circular.obj');
  const press = ['--panels', 'circle', '--within', 'auto', '--out', out];
  execFileSync(program, ['solve', mesh.path, ...press]);
  return positionsOf(readFileSync(out, 'utf8'));
}

for (const { name, path, start } of [firefox, webkit]) {
  const found = pathOf('Xvfb') && path();
  const title = found ? `a file becomes circular panels in ${name}` : `there is no ${name}`;
  test(title, { skip: !found, timeout: 600_000 }, async (t) => {
    try {
      const browser = await start(found, await beginScreen());
      const { renderer, circular } = await tell(browser, address, mesh);
      t.diagnostic(`${name} draws by ${renderer}`);
      assert.deepEqual(circular, expected(), 'to the last bit');
    } finally {
      await endAll();
    }
  });
}
