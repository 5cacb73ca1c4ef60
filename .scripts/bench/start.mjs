// Time to open the page: in a new browser profile (cold), and in the same profile again (warm).

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findBrowser, webgl2Flags } from '../browser.mjs';
import { at } from '../project.mjs';
import { say } from '../run.mjs';
import { host } from './host.mjs';
import { medians } from './statistics.mjs';

/** Timeout of opening the page. */
const LONGEST_MS = 120_000;

/** In the page, before its own scripts: records the times. */
function watch() {
  const marks = {};
  Object.assign(window, { benchMarks: marks });
  const mark = (name, reached) => {
    if (reached && !(name in marks)) marks[name] = performance.now();
  };
  const look = () => {
    const state = window.shapeUp?.state();
    mark('solved', state?.converged);
    mark('drawn', state && state.renderer !== 'none' && !document.getElementById('first-picture'));
    if (!('drawn' in marks && 'solved' in marks)) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** Opens the page once in a profile; returns milliseconds since the navigation began, and bytes. */
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
    const there = () => 'drawn' in window.benchMarks && 'solved' in window.benchMarks;
    await page.waitForFunction(there, null, { timeout: LONGEST_MS });
    const times = await page.evaluate(() => {
      const [painted] = performance.getEntriesByName('first-contentful-paint');
      return { painted: painted?.startTime ?? null, ...window.benchMarks };
    });
    // Compiled code is written to the profile a moment later.
    await page.waitForTimeout(1500);
    const { painted, solved, drawn } = times;
    return { painted, solved, drawn, bytes: server.takeBytes() };
  } finally {
    await context.close();
  }
}

/** Returns the medians over some new profiles of the first, second and third visit. */
export async function measureStart(rounds) {
  const { chromium } = await import('@playwright/test');
  const server = await host({ folders: { '/': at('dist') }, compress: true });
  const visits = { cold: [], warm: [], again: [] };
  for (let round = 0; round < rounds; round++) {
    say(`opening the page, profile ${round + 1} of ${rounds}`);
    const profile = mkdtempSync(join(tmpdir(), 'shape-up-bench-'));
    try {
      for (const done of Object.values(visits)) done.push(await visit(chromium, profile, server));
    } finally {
      rmSync(profile, { recursive: true, force: true });
    }
  }
  server.close();
  return Object.fromEntries(Object.entries(visits).map(([name, done]) => [name, medians(done)]));
}
