// The page tests: dist/ on its own port, in a desktop and a phone window.

import { defineConfig } from '@playwright/test';
import { browserFlags, findBrowser, webgl2Flags } from '../../.scripts/browser.mjs';
import { freePort } from '../../.scripts/serve.mjs';
import { leftOut } from './nightly.ts';

// This file is read again in every worker process, which inherits the port of the first.
process.env.SHAPE_UP_TEST_PORT ??= String(await freePort());
const port = process.env.SHAPE_UP_TEST_PORT;
// Not the root of the host: the site must work under any path.
const base = '/some/sub-path/';
const url = `http://127.0.0.1:${port}${base}`;

/** Specs that depend on the layout of a phone; the others run on the desktop only. */
const ARRANGED = [
  'axe',
  'first-picture',
  'first-visit',
  'layout',
  'messages',
  'phone',
  'shaping',
  'touch',
];

/** The spec that compares WebGPU and WebGL2, in a browser that has both. */
const BOTH = 'backends';

/** The specs that measure time; `npm test` runs them alone, before the others. */
const ALONE = ['drag-speed', 'build-large'];

const specs = (names: string[]) => names.map((name) => `**/${name}.spec.ts`);
const executablePath = (await findBrowser()) ?? undefined;
const launched = (args: string[]) => ({ launchOptions: { executablePath, args } });

/**
 * A function of a module is examined only when it is called, and is never compiled once more, for
 * speed: most pages of the tests do not live that long.
 */
const lazily = '--js-flags=--wasm-lazy-validation --liftoff-only';

export default defineConfig({
  testDir: '.',
  testMatch: '*.spec.ts',
  outputDir: '../../test-results',
  reporter: 'list',
  // A test that passes only on the second try is reported and fails the run: see
  // .scripts/count.mjs.
  retries: 1,
  workers: 2,
  fullyParallel: true,
  forbidOnly: true,
  // SwiftShader draws a few pictures a second on two cores.
  timeout: 120_000,
  expect: { timeout: 30_000 },
  use: {
    baseURL: url,
    // A service worker would answer in place of the server, whose answers some tests hold back.
    serviceWorkers: 'block',
    screenshot: 'only-on-failure',
    ...launched([...webgl2Flags, lazily]),
  },
  projects: [
    {
      name: 'desktop',
      // Without animations, which take a tenth of the processor time; those about them ask for them,
      // and on a phone there are all.
      use: {
        viewport: { width: 1440, height: 900 },
        contextOptions: { reducedMotion: 'reduce' },
      },
      // Touch tests are for the phone.
      testIgnore: specs(['phone', 'touch', BOTH, ...ALONE]),
      grepInvert: leftOut(/@phone/),
    },
    {
      name: 'both',
      use: { viewport: { width: 1440, height: 900 }, ...launched([...browserFlags, lazily]) },
      testMatch: specs([BOTH]),
      grepInvert: leftOut(),
    },
    {
      name: 'alone',
      use: { viewport: { width: 1440, height: 900 }, ...launched(webgl2Flags) },
      testMatch: specs(ALONE),
      dependencies: ['desktop', 'both', 'phone'],
    },
    {
      name: 'phone',
      use: { viewport: { width: 390, height: 844 } },
      testMatch: specs(ARRANGED),
      grepInvert: leftOut(/@desktop/),
    },
  ],
  webServer: {
    command: `node ../../.scripts/serve.mjs ${port} ${base}`,
    url,
    reuseExistingServer: false,
  },
});
