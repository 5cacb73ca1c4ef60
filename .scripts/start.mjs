// npm start: sets up, builds, and serves the page.

import { build } from './build.mjs';
import { at } from './project.mjs';
import { main } from './run.mjs';
import { serve } from './serve.mjs';
import { setUp } from './setup.mjs';

await main(async () => {
  await setUp({ checks: false });
  await build();
  const { address } = await serve(at('dist'), { port: 4173 });
  console.log(`Shape-Up is ready: ${address}`);
});
