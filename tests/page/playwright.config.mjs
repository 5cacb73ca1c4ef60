// The page tests: dist/ on a port of its own, in a desktop and in a phone window.

import { defineConfig } from '@playwright/test';
import { createServer } from 'node:net';
import { browserFlags, findBrowser, webgl2Flags } from '../../.scripts/browser.mjs';

/** A port that nobody listens on now. */
function freePort() {
  return new Promise((done) => {
    const probe = createServer().listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

// This file is read again in every worker process, which inherits the choice of the first.
process.env.SHAPE_UP_TEST_PORT ??= String(await freePort());
const port = process.env.SHAPE_UP_TEST_PORT;
// Not the top of the host: the site has to work from any sub-path.
const base = '/some/sub-path/';
const url = `http://127.0.0.1:${port}${base}`;

/** What a phone shows in another arrangement than other windows. The rest lies behind it. */
const ARRANGED = [
  'axe',
  'placeholder',
  'first-visit',
  'layout',
  'messages',
  'phone',
  'shaping',
  'touch',
];

/** What tells WebGPU from WebGL2, in a browser that has both. */
const BOTH = 'backends';

/** What measures time has the machine to itself: `npm test` runs it before the others. */
const ALONE = 'drag-speed';

const specs = (names) => names.map((name) => `**/${name}.spec.mjs`);
const executablePath = (await findBrowser()) ?? undefined;
const launched = (args) => ({ launchOptions: { executablePath, args } });

export default defineConfig({
  testDir: '.',
  testMatch: '*.spec.mjs',
  outputDir: '../../test-results',
  reporter: 'list',
  // What passes only the second time is told of, and fails the run: see .scripts/count.mjs.
  retries: 1,
  workers: 2,
  fullyParallel: true,
  forbidOnly: true,
  // SwiftShader draws a few pictures a second on two cores.
  timeout: 120_000,
  expect: { timeout: 30_000 },
  use: {
    baseURL: url,
    // It would answer for the server, whose answers tests hold back.
    serviceWorkers: 'block',
    screenshot: 'only-on-failure',
    ...launched(webgl2Flags),
  },
  projects: [
    {
      name: 'desktop',
      use: { viewport: { width: 1440, height: 900 } },
      // Fingers are the phone's.
      testIgnore: specs(['phone', 'touch', BOTH, ALONE]),
      grepInvert: /@phone/,
    },
    {
      name: 'both',
      use: { viewport: { width: 1440, height: 900 }, ...launched(browserFlags) },
      testMatch: specs([BOTH]),
    },
    {
      name: 'alone',
      use: { viewport: { width: 1440, height: 900 } },
      testMatch: specs([ALONE]),
      dependencies: ['desktop', 'both', 'phone'],
    },
    {
      name: 'phone',
      use: { viewport: { width: 390, height: 844 } },
      testMatch: specs(ARRANGED),
      grepInvert: /@desktop/,
    },
  ],
  webServer: {
    command: `node ../../.scripts/serve.mjs ${port} ${base}`,
    url,
    reuseExistingServer: false,
  },
});
