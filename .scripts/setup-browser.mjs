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
  const missing = ['firefox-esr', 'WebKitWebDriver', 'Xvfb'].filter(
    (program) => outputOf('which', [program]) === null,
  );
  if (missing.length === 0 || !apt.canInstall()) return;
  say('installing Firefox and WebKit');
  // The libraries are those by which Firefox draws without a graphics card.
  await apt.install('firefox-esr', 'libegl1', 'libgl1', 'webkit2gtk-driver', 'xvfb');
}
