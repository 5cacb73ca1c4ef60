// The Chromium that runs the tests: which one, and how it is started.

import { existsSync } from 'node:fs';
import { outputOf, Problem } from './run.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

// Ubuntu's chromium-browser is there without a Chromium behind it: a browser has to answer.
const starts = (path) => outputOf(path, ['--version']) !== null;

/**
 * The path of a Chromium that starts: the one named by the environment variable CHROME, else the
 * system's, else Playwright's own. Null where there is none.
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
 * A window of a system's Chromium starts a process for the list under its bar of addresses, which takes
 * as long as a third of a page; and it asks its maker about the fields of forms. The others are
 * Playwright's own, whose list this one takes the place of.
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
 * Draws WebGPU and WebGL2 by SwiftShader, so that no graphics card is needed. The compositor must
 * run on the same Vulkan as WebGPU: without the last three flags its canvas stays blank.
 */
export const browserFlags = [
  ...quiet,
  '--enable-unsafe-webgpu',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
];

/**
 * Draws WebGL2 alone by SwiftShader. The page around the picture is not SwiftShader's, so that a
 * page is used in two thirds of the time.
 */
export const webgl2Flags = [
  ...quiet,
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-gpu-compositing',
];
