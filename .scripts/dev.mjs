// npm run dev: serves the page from www/ and reloads it on changes.

import { buildParts } from './build.mjs';
import { main } from './run.mjs';
import { setUp } from './setup.mjs';
import { viteConfig } from './site.mjs';

await main(async () => {
  await setUp({ checks: false });
  await buildParts();
  const vite = await import('vite');
  const server = await vite.createServer({ configFile: viteConfig });
  await server.listen();
  server.printUrls();
});
