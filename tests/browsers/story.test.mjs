// A story in browsers other than that of the page tests, where they can be had.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { at } from '../../.scripts/project.mjs';
import { serve } from '../../.scripts/serve.mjs';
import { firefox } from './firefox.mjs';
import { beginScreen, endAll, pathOf } from './programs.mjs';
import { tell } from './story.mjs';
import { webkit } from './webkit.mjs';

const { address, close } = await serve(at('dist'), { port: 0 });
test.after(close);

/** The shapes that were found so far. */
const shapes = new Set();

for (const { name, path, start } of [firefox, webkit]) {
  const found = pathOf('Xvfb') && path();
  const title = found ? `a file becomes circular panels in ${name}` : `there is no ${name}`;
  test(title, { skip: !found }, async (t) => {
    try {
      const { renderer, shape } = await tell(await start(found, await beginScreen()), address);
      t.diagnostic(`${name} draws by ${renderer}`);
      assert.equal(shapes.add(shape).size, 1, 'all browsers find the same shape, to the last bit');
    } finally {
      await endAll();
    }
  });
}
