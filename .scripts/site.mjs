// The static site: the page bundled with everything it loads, in dist/.

import { join } from 'node:path';
import { at } from './project.mjs';
import { Problem, say } from './run.mjs';
import { writeSources } from './sources.mjs';
import { unlessUnchanged } from './stamp.mjs';

export const viteConfig = at('.scripts', 'vite.config.mjs');

/** What decides over the site, but for the archives of sources: bundling takes seconds. */
export const inputs = () =>
  [
    ...['www', '.scripts', 'LICENSE', 'package-lock.json', 'Cargo.lock'],
    join('src', 'solve', 'performance.md'),
  ].map((name) => at(name));

/** Bundles `www/` into `dist/`. */
export async function bundleSite() {
  const output = at('dist', 'index.html');
  await unlessUnchanged({ name: 'site', inputs: inputs(), output }, async () => {
    say('bundling the page into dist/');
    const vite = await import('vite');
    try {
      await vite.build({ configFile: viteConfig, logLevel: 'warn' });
    } catch (error) {
      throw new Problem(`The page cannot be bundled: ${error.message}`);
    }
  });
  writeSources(at('dist', 'sources'));
}
