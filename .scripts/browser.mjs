// The Chromium that runs the tests: which one, and how it is started.

import { existsSync } from 'node:fs';
import { outputOf } from './run.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

/**
 * The path of a Chromium that starts: the one named by the environment variable CHROME, the
 * system's, or Playwright's own. Null where there is none.
 */
export async function findBrowser() {
  const named = process.env.CHROME;
  for (const name of named ? [named] : names) {
    const path = outputOf('which', [name]);
    // Ubuntu's chromium-browser is there without a Chromium behind it: it has to answer.
    if (path && outputOf(path, ['--version']) !== null) return path;
  }
  const { chromium } = await import('@playwright/test');
  const own = chromium.executablePath();
  return existsSync(own) && outputOf(own, ['--version']) !== null ? own : null;
}

/**
 * Draws WebGPU and WebGL2 by SwiftShader, so that no graphics card is needed. The compositor must
 * run on the same Vulkan as WebGPU: without the last three flags its canvas stays blank.
 */
export const browserFlags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--enable-unsafe-webgpu',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
];
