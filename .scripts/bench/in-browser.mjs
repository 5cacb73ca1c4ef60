// The part in headless Chromium: the solver module as shipped, in a new worker for every task, and
// the site's own worker as the page runs it.

import { existsSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { browserFlags, findBrowser } from '../browser.mjs';
import { at, targetFolder, wasmTarget } from '../project.mjs';
import { Problem, run, say } from '../run.mjs';
import { setUpBindgen, wasmBindgen } from '../setup-bindgen.mjs';
import { sizeFlags } from '../wasm.mjs';
import { host, isolation } from './host.mjs';
import { benchFolder } from './problems.mjs';

const moduleFolder = join(benchFolder, 'module');
const name = 'bench_browser';

/** Builds the module of tests/bench/browser.rs: single operators, and reading of memory. */
export async function buildBenchModule() {
  say('compiling what is measured in the browser beside the solver');
  await setUpBindgen();
  await run('cargo', [
    ...['rustc', '--locked', '--release', '--quiet', '--example', name],
    ...['--target', wasmTarget, '--no-default-features', '--features', 'solver'],
    // The flags of the site's own module, with which it is compared.
    ...['--', ...sizeFlags],
  ]);
  const compiled = join(targetFolder, wasmTarget, 'release', 'examples', `${name}.wasm`);
  await run(wasmBindgen, ['--target', 'web', '--out-dir', moduleFolder, compiled]);
}

/** In the page: passes a task to a new worker and returns its result. */
function performInWorker(task) {
  return new Promise((done, reject) => {
    const worker = new Worker('/worker/worker.mjs', { type: 'module' });
    worker.onerror = (event) => reject(new Error(event.message));
    worker.onmessage = ({ data: { ready, result, error } }) => {
      if (ready) return worker.postMessage(task);
      worker.terminate();
      if (error) reject(new Error(error));
      else done(result);
    };
  });
}

/**
 * In the page: opens a problem in the site's own worker, presses Run, and returns milliseconds per
 * iteration, including everything else the worker does.
 */
function runSiteWorker({ address, files, move, settle, during }) {
  return new Promise((done, reject) => {
    const worker = new Worker(address, { type: 'module' });
    const say = (message) => worker.postMessage(message);
    const failed = (message) => (worker.terminate(), reject(new Error(message)));
    /** The last frame before settling, and the time at which settling ends. */
    let start = { ms: 0, iteration: 0 };
    let settledAt = Infinity;
    worker.onerror = (event) => failed(event.message);
    worker.onmessage = async ({ data }) => {
      if (data.type === 'ready') {
        const read = async (file) => new Uint8Array(await (await fetch(file.url)).arrayBuffer());
        const bytes = (file) => (file.text ? new TextEncoder().encode(file.text) : read(file));
        const opened = files.map(async (file) => ({ name: file.name, bytes: await bytes(file) }));
        say({ type: 'open', id: 1, files: await Promise.all(opened) });
      } else if (data.type === 'reply') {
        const vertices = Uint32Array.from(move, ([vertex]) => vertex);
        const targets = Float64Array.from(move.flatMap(([, to]) => to));
        for (const phase of move.length ? ['start', 'end'] : []) {
          say({ type: 'drag', vertices, targets, phase });
        }
        say({ type: 'run' });
        settledAt = performance.now() + settle;
      } else if (data.type === 'frame') {
        const ms = performance.now();
        const { iteration } = data.numbers;
        if (ms < settledAt) start = { ms, iteration };
        else if (ms > settledAt + during && iteration > start.iteration) {
          worker.terminate();
          return done((ms - start.ms) / (iteration - start.iteration));
        }
        // The page returns a buffer after drawing.
        requestAnimationFrame(() => say({ type: 'recycle', positions: data.positions }));
      } else if (['refused', 'died', 'trouble'].includes(data.type)) {
        failed(data.message);
      }
    };
  });
}

/** Starts the browser; returns { version, canStream, perform, run, operators, close }. */
export async function browserSolver() {
  const { chromium } = await import('@playwright/test');
  const worker = readdirSync(at('dist', 'assets')).find((file) =>
    /^solver-worker.*\.js$/.test(file),
  );
  if (!worker) throw new Problem('dist/ has no worker of the solver: npm run build');
  const { address, close } = await host({
    folders: {
      '/solver/': at('www', 'pkg', 'solver'),
      '/site/': at('dist'),
      '/bench/': moduleFolder,
      '/worker/': at('.scripts', 'bench'),
      '/meshes/': benchFolder,
    },
    pages: { '/': '<!doctype html><title>bench</title>' },
    headers: isolation,
  });
  const browser = await chromium.launch({
    executablePath: (await findBrowser()) ?? undefined,
    args: browserFlags,
  });
  const page = await browser.newPage();
  await page.goto(address);
  const meshUrl = (problem) => `/meshes/${basename(problem.mesh)}`;
  const forPage = (problem) => problem && { ...problem, mesh: meshUrl(problem) };
  return {
    version: browser.version(),
    /** Whether the module that reads memory at full speed was built. */
    canStream: () => existsSync(join(moduleFolder, `${name}.js`)),
    perform: ({ problem, problems, ...task }) =>
      page.evaluate(performInWorker, {
        ...task,
        problem: forPage(problem),
        problems: problems?.map(forPage),
      }),
    /** Returns milliseconds per iteration of the site's own worker. */
    run: (problem, { settle, during }) =>
      page.evaluate(runSiteWorker, {
        address: `/site/assets/${worker}`,
        files: [
          { name: 'problem.shapeup.json', text: problem.scene },
          { name: basename(problem.mesh), url: meshUrl(problem) },
        ],
        move: problem.move,
        settle,
        during,
      }),
    /** Returns the table of all operators, in Markdown. */
    operators: () =>
      page.evaluate(async (url) => {
        const module = await import(url);
        await module.default();
        return module.operators();
      }, `/bench/${name}.js`),
    async close() {
      await browser.close();
      close();
    },
  };
}
