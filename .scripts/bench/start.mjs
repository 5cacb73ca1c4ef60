// Time to open the page: three visits in a new browser profile, of which the first one is cold.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findBrowser, webgl2Flags } from '../browser.mjs';
import { at } from '../project.mjs';
import { host } from './host.mjs';
import { medians } from './statistics.mjs';

const visits = ['first visit', 'second visit', 'third visit'];

/** In the page, before its own scripts: records the times. */
function watch() {
  const times = {};
  Object.assign(window, { benchTimes: times });
  const look = () => {
    const state = window.shapeUp?.state();
    const isDrawn =
      state && state.renderer.startsWith('web') && !document.getElementById('first-picture');
    if (state?.converged) times.solved ??= performance.now();
    if (isDrawn) times.drawn ??= performance.now();
    if (!(times.drawn && times.solved)) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** Opens the page once in a profile; returns milliseconds since the navigation began, and kB. */
async function visit(chromium, profile, server) {
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: (await findBrowser()) ?? undefined,
    // Without GPU compositing: SwiftShader would take seconds for it, unlike any user's machine.
    args: webgl2Flags,
    viewport: { width: 1440, height: 900 },
  });
  try {
    const page = await context.newPage();
    await page.addInitScript(watch);
    server.takeBytes();
    await page.goto(server.address);
    await page.waitForFunction(() => window.benchTimes.drawn && window.benchTimes.solved, null, {
      timeout: 120_000,
    });
    const times = await page.evaluate(() => {
      const [painted] = performance.getEntriesByName('first-contentful-paint');
      return { painted: painted?.startTime ?? null, ...window.benchTimes };
    });
    // Compiled code is written to the profile a moment later.
    await page.waitForTimeout(1500);
    return { ...times, kB: server.takeBytes() / 1e3 };
  } finally {
    await context.close();
  }
}

/** Returns a row for each visit: medians over some new profiles, rounded. */
export async function measureStart(profiles) {
  const { chromium } = await import('@playwright/test');
  const server = await host({ folders: { '/': at('dist') } });
  const all = visits.map(() => []);
  for (let k = 0; k < profiles; k++) {
    const profile = mkdtempSync(join(tmpdir(), 'shape-up-bench-'));
    try {
      for (const done of all) done.push(await visit(chromium, profile, server));
    } finally {
      rmSync(profile, { recursive: true, force: true });
    }
  }
  server.close();
  return all.map((done, k) => {
    const rounded = Object.entries(medians(done)).map(([key, value]) => [key, Math.round(value)]);
    return { visit: visits[k], ...Object.fromEntries(rounded) };
  });
}
