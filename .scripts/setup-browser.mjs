// A browser for the tests: the system's, else Playwright's download, else the system's package.

import * as apt from './apt.mjs';
import { findBrowser } from './browser.mjs';
import { outputOf, Problem, run, say } from './run.mjs';

/** Ensures that `findBrowser` finds a browser. */
export async function setUpBrowser() {
  if (await findBrowser()) return;
  const ways = [downloadChromium, ...(apt.canInstall() ? [installChromium] : [])];
  for (const way of ways) {
    try {
      await way();
      if (await findBrowser()) return;
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      say(error.message);
    }
  }
  throw new Problem(
    'No browser for the tests. Install one: sudo apt install chromium-headless-shell',
  );
}

async function downloadChromium() {
  say("downloading Playwright's Chromium");
  const withLibraries = apt.canInstall() ? ['--with-deps'] : [];
  await run('npx', ['playwright', 'install', ...withLibraries, 'chromium'], {
    env: { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '10000' },
  });
}

async function installChromium() {
  say('installing the system package chromium-headless-shell');
  await apt.install('chromium-headless-shell');
}

/** Installs what `tests/browsers` drives, where that can be done without asking the user. */
export async function setUpOtherBrowsers() {
  const lacks = (...names) => names.every((name) => outputOf('which', [name]) === null);
  if (!apt.canInstall()) return;
  const packages = [
    // With the libraries by which Firefox draws without a graphics card.
    ...(lacks('firefox', 'firefox-esr') ? ['firefox-esr', 'libegl1', 'libgl1'] : []),
    ...(lacks('WebKitWebDriver') ? ['webkit2gtk-driver'] : []),
    ...(lacks('Xvfb') ? ['xvfb'] : []),
  ];
  if (packages.length === 0) return;
  say('installing Firefox and WebKit');
  await apt.install(...packages).catch(({ message }) => say(message));
}
