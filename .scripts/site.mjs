// The static site: the page bundled with everything it loads, in dist/.

import { at } from './project.mjs';
import { Problem, say } from './run.mjs';
import { writeSources } from './sources.mjs';
import { filesUnder, unlessUnchanged } from './stamp.mjs';

export const viteConfig = at('.scripts', 'vite.config.mjs');

/** Bundles `www/` into `dist/`. */
export async function bundleSite() {
  const inputs = [
    ...filesUnder(at('www')),
    ...['vite.config', 'offline', 'policy', 'licences', 'licences-page', 'speed-page'].map((name) =>
      at('.scripts', `${name}.mjs`),
    ),
    ...['package-lock.json', 'Cargo.lock', 'src/solve/performance.md'].map((name) => at(name)),
  ];
  const output = at('dist', 'index.html');
  await unlessUnchanged({ name: 'site', inputs, output }, async () => {
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
