// npm run bench: problem A (a circle on every quad, weights 5, 10, 2, closeness to the surface) in
// headless Chromium, in a worker as the page runs it: milliseconds by part, medians of single steps
// over several runs, the plain iteration and the accelerated one in turn.

import { findBrowser, browserFlags } from './browser.mjs';
import { at } from './project.mjs';
import { main } from './run.mjs';
import { serve } from './serve.mjs';
import { setUp } from './setup.mjs';
import { buildModule } from './wasm.mjs';

/** Vertices along each side of the square grids. */
const sides = [50, 100, 173];
const accelerators = ['none', 'quasi-newton'];
const steps = 60;
const rounds = 3;

/** A jittered, bumpy height field of quads as OBJ text. */
function grid(side) {
  const lines = [];
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const jitter = (k) => (((i * 7919 + j * 104729 + k * 1299709) % 1009) / 1009 - 0.5) * 0.3;
      const [x, y] = [i + jitter(1), j + jitter(2)];
      const z = 0.1 * side * Math.sin((5 * x) / side) * Math.cos((4 * y) / side) + 0.3 * jitter(3);
      lines.push(`v ${x} ${y} ${z}`);
    }
  }
  for (let j = 0; j + 1 < side; j++) {
    for (let i = 1; i < side; i++) {
      const a = j * side + i;
      lines.push(`f ${a} ${a + 1} ${a + side + 1} ${a + side}`);
    }
  }
  return lines.join('\n');
}

const scene = (accelerator) =>
  JSON.stringify({
    format: 'shape-up-scene',
    version: 1,
    mesh: { file: 'grid.obj' },
    constraints: [{ kind: 'circle', on: 'faces' }],
    weights: { shape: 5, close: 10, smooth: 2 },
    solver: { accelerator, tolerance: 0 },
  });

/** Runs in the worker: the report, and the milliseconds of each step by part. */
const workerSource = `
  import init, { Solver } from '/solver/shape_up.js';
  onmessage = async ({ data: { scene, obj, steps } }) => {
    await init();
    const solver = new Solver();
    const bytes = (text) => new TextEncoder().encode(text);
    solver.load('grid.shapeup.json', bytes(scene), bytes(obj));
    const parts = [];
    let before = solver.report().seconds.parts;
    for (let k = 0; k < steps; k++) {
      solver.step();
      const now = solver.report().seconds.parts;
      parts.push(Object.fromEntries(Object.keys(now).map((key) => [key, 1e3 * (now[key] - before[key])])));
      before = now;
    }
    postMessage({ report: solver.report(), parts });
  };`;

/** With these a page is isolated, and its clock steps by 5 microseconds rather than by 100. */
const isolated = {
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-embedder-policy': 'require-corp',
};

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

await main(async () => {
  await setUp({ checks: true });
  const { chromium } = await import('@playwright/test');
  await buildModule('solver');
  const { address, close } = await serve(at('www', 'pkg'), { port: 4400 });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: browserFlags,
  });
  const page = await browser.newPage();
  await page.route(`${address}bench.js`, (route) =>
    route.fulfill({ contentType: 'text/javascript', headers: isolated, body: workerSource }),
  );
  await page.route(`${address}`, (route) =>
    route.fulfill({
      contentType: 'text/html',
      headers: isolated,
      body: '<!doctype html><title>bench</title>',
    }),
  );
  await page.goto(address);
  const runOne = (task) =>
    page.evaluate(
      (task) =>
        new Promise((done, reject) => {
          const worker = new Worker('/bench.js', { type: 'module' });
          worker.onerror = (event) => reject(new Error(event.message));
          worker.onmessage = ({ data }) => (worker.terminate(), done(data));
          worker.postMessage(task);
        }),
      task,
    );
  console.log(
    '| vertices | accelerator | ms per iteration | circles | closeness | smoothness | solve | order | factor | nonzeros of L |',
  );
  console.log('|---|---|---|---|---|---|---|---|---|---|');
  for (const side of sides) {
    const obj = grid(side);
    const runs = new Map(accelerators.map((accelerator) => [accelerator, []]));
    for (let round = 0; round < rounds; round++) {
      for (const [accelerator, done] of runs) {
        done.push(await runOne({ scene: scene(accelerator), obj, steps }));
      }
    }
    for (const [accelerator, done] of runs) {
      // The first steps run in code that is not optimised yet.
      const warm = done.flatMap(({ parts }) => parts.slice(10));
      const of = (key) => median(warm.map((part) => part[key]));
      const whole = median(warm.map((p) => p.shape + p.close + p.smooth + p.global));
      const set = (key) => 1e3 * median(done.map(({ report }) => report.seconds[key]));
      const ms = [whole, of('shape'), of('close'), of('smooth'), of('global')];
      const cells = [...ms, set('order'), set('factor')].map((value) => value.toFixed(2));
      const { vertices, factor_nonzeros: nonzeros } = done[0].report;
      console.log(`| ${[vertices, accelerator, ...cells, nonzeros].join(' | ')} |`);
    }
  }
  await browser.close();
  close();
});
