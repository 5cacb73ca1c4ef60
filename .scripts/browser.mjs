// The Chromium that runs the tests: its path and its flags.

import { existsSync } from 'node:fs';
import { outputOf, Problem } from './run.mjs';

/** The one without a window of its own first: the page tests take a sixth less time in it. */
const names = [
  ...['chromium-headless-shell', 'chromium', 'chromium-browser'],
  ...['google-chrome', 'google-chrome-stable'],
];

// Ubuntu's chromium-browser may be a stub without a Chromium: a browser has to answer.
const starts = (path) => outputOf(path, ['--version']) !== null;

/**
 * Returns the path of a Chromium that starts: the one named by the environment variable CHROME,
 * else the system's, else Playwright's own; null if there is none.
 */
export async function findBrowser() {
  const named = process.env.CHROME;
  if (named && !starts(named)) throw new Problem(`CHROME=${named}: no browser starts there`);
  if (named) return named;
  for (const name of names) {
    const path = outputOf('which', [name]);
    if (path && starts(path)) return path;
  }
  const { chromium } = await import('@playwright/test');
  const own = chromium.executablePath();
  return existsSync(own) && starts(own) ? own : null;
}

/**
 * Features to disable. A system's Chromium starts a process for the list under its address bar,
 * which takes a third of the time of a page, and it contacts a server about form fields. The other
 * features are those that Playwright disables, whose list is replaced by this one.
 */
const unwanted = [
  'AutofillServerCommunication',
  ...['WebUIOmniboxPopup', 'WebUIOmniboxFullPopup', 'WebUIOmniboxAimPopup'],
  ...['AvoidUnnecessaryBeforeUnloadCheckSync', 'DestroyProfileOnBrowserClose', 'HttpsUpgrades'],
  ...['HttpsFirstBalancedModeAutoEnable', 'LensOverlay', 'MediaRouter', 'PaintHolding'],
  ...['ThirdPartyStoragePartitioning', 'AvoidCorsURLLoaderRestartOnRedirect', 'OptimizationHints'],
  ...['NetworkTimeServiceQuerying', 'AimEnabled', 'PreconnectToSearch'],
];

const quiet = [
  `--disable-features=${unwanted}`,
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/**
 * Draws WebGPU and WebGL2 by SwiftShader, without a graphics card. The compositor must run on the
 * same Vulkan as WebGPU: without the last three flags its canvas stays blank.
 */
export const browserFlags = [
  ...quiet,
  '--enable-unsafe-webgpu',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
];

/**
 * Draws only WebGL2 by SwiftShader. The rest of the page is not composited by SwiftShader, which
 * makes using a page a third faster.
 */
export const webgl2Flags = [
  ...quiet,
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-gpu-compositing',
];
