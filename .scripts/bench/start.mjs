// Time to open the page: three visits in a new browser profile, of which the first one is cold.

import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import { gzipSync } from 'node:zlib';
import { findBrowser, webgl2Flags } from '../browser.mjs';
import { at } from '../project.mjs';
import { serve } from '../serve.mjs';
import { benchFolder } from './problems.mjs';
import { spreads } from './statistics.mjs';

const VISITS = ['first visit', 'second visit', 'third visit'];
/** New profiles, over which the times are spread. */
const PROFILES = 5;

/** Serves dist/ as the host of the site does: compressed. `sent()` is the bytes of all bodies so far. */
async function host() {
  /** Compressed once, so that no visit waits for it. */
  const bodies = new Map();
  let bytes = 0;
  const read = (file) => {
    if (!bodies.has(file)) bodies.set(file, gzipSync(readFileSync(file), { level: 9 }));
    bytes += bodies.get(file).length;
    return Readable.from([bodies.get(file)]);
  };
  const extra = { 'content-encoding': 'gzip', 'cache-control': 'max-age=600' };
  const server = await serve(at('dist'), { port: 0, extra, read });
  return { ...server, sent: () => bytes };
}

/** In the page: the time, if its first model is solved. */
const solvedAt = () => window.shapeUp?.state().converged && performance.now();

/** In the page: the time, if its first model is drawn. */
const drawnAt = () =>
  window.shapeUp?.state().renderer.startsWith('web') &&
  !document.getElementById('first-picture') &&
  performance.now();

const paintedAt = () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime;

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
    page.setDefaultTimeout(120_000);
    const before = server.sent();
    await page.goto(server.address, { waitUntil: 'commit' });
    // Asked in every frame.
    const reached = [solvedAt, drawnAt].map((asked) => page.waitForFunction(asked));
    const [solved, drawn] = await Promise.all(reached);
    const painted = await page.evaluate(paintedAt);
    // Compiled code is written to the profile a moment later.
    await page.waitForTimeout(1500);
    const ms = { painted, solved: await solved.jsonValue(), drawn: await drawn.jsonValue() };
    return { ...ms, kB: (server.sent() - before) / 1e3 };
  } finally {
    await context.close();
  }
}

/** Returns a row for each visit. */
export async function measureStart() {
  const { chromium } = await import('@playwright/test');
  const server = await host();
  const profile = join(benchFolder, 'profile');
  const all = VISITS.map(() => []);
  try {
    for (let k = 0; k < PROFILES; k++) {
      rmSync(profile, { recursive: true, force: true });
      for (const done of all) done.push(await visit(chromium, profile, server));
    }
  } finally {
    server.close();
  }
  return VISITS.map((name, k) => ({ visit: name, seen: spreads(all[k]) }));
}
