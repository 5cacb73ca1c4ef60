// The package of the engine, installed in an empty folder, in Node and in a page.

import { chromium } from '@playwright/test';
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { findBrowser, webgl2Flags } from '../../.scripts/browser.mjs';
import { writePackage } from '../../.scripts/package.mjs';
import { at } from '../../.scripts/project.mjs';
import { serve } from '../../.scripts/serve.mjs';

/** A vault of quads, 8 along a half circle and 5 along the axis; the inner vertices are moved a little. */
function vault() {
  const lines = [];
  for (let j = 0; j <= 5; j++)
    for (let i = 0; i <= 8; i++) {
      const isInner = i % 8 !== 0 && j % 5 !== 0;
      const angle = (Math.PI * (i + (isInner ? 0.15 * Math.sin(7 * i + 3 * j) : 0))) / 8;
      lines.push(`v ${3 * Math.cos(angle)} ${j} ${3 * Math.sin(angle)}`);
    }
  for (let j = 0; j < 5; j++)
    for (let i = 1; i <= 8; i++)
      lines.push(`f ${[i, i + 1, i + 10, i + 9].map((v) => v + 9 * j).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

/** Returns what TypeScript finds wrong with some files of a folder. */
function typeErrors(cwd, ...files) {
  const compiler = at('node_modules', 'typescript', 'bin', 'tsc');
  const options = '--noEmit --allowJs --checkJs --strict false --skipLibCheck --pretty false';
  const modules = '--target esnext --module esnext --moduleResolution bundler';
  const words = `${options} ${modules}`.split(' ');
  const found = spawnSync('node', [compiler, ...words, ...files], { cwd, encoding: 'utf8' });
  return found.stdout + found.stderr;
}

const folder = mkdtempSync(join(tmpdir(), 'shape-up-package-'));
/** The package, once it is installed. */
const installed = join(folder, 'node_modules', 'shape-up-engine');
const run = (command, ...words) => execFileSync(command, words, { cwd: folder, encoding: 'utf8' });
/** What the example for Node says about a mesh file, whose result it writes. */
const solve = (name) => run('node', join(installed, 'examples', 'solve.mjs'), name, 'out.obj');
after(() => rmSync(folder, { recursive: true }));

before(() => {
  writePackage(join(folder, 'made'));
  writeFileSync(join(folder, 'vault.obj'), vault());
  writeFileSync(join(folder, 'package.json'), '{ "private": true }');
});

test('the engine is packed, installed in an empty project, and solves', () => {
  const [{ filename, files }] = JSON.parse(run('npm', 'pack', '--json', './made'));
  const names = files.map(({ path }) => path);
  for (const name of [
    'LICENSE',
    'README.md',
    'licences.txt',
    'sources/shape-up.tar.gz',
    'index.d.ts',
    'shape_up_bg.wasm',
  ])
    assert.ok(names.includes(name), `${name} of ${names}`);
  // A bundler for pages would look for the modules of Node.
  assert.doesNotMatch(readFileSync(join(folder, 'made', 'index.js'), 'utf8'), /node:/);
  run('npm', 'install', '--offline', '--no-audit', '--no-fund', `./${filename}`);
  assert.match(solve('vault.obj'), /All 40 panels are circular within /);
  const out = readFileSync(join(folder, 'out.obj'), 'utf8');
  assert.equal(out.match(/^v /gm)?.length, 54);
  // The program of the README.
  const readme = readFileSync(join(folder, 'made', 'README.md'), 'utf8');
  const [, code] = /```js\n([^]*?)```/.exec(readme);
  const bytes = "const bytes = (await import('node:fs')).readFileSync('vault.obj');\n";
  writeFileSync(
    join(folder, 'readme.mjs'),
    code.replace('await load();', `await load();\n${bytes}`),
  );
  assert.match(run('node', 'readme.mjs'), /All 40 panels are circular within /);
  // What the README calls stable is declared, and so is what the example for pages calls.
  const [, stable] = /## What is stable\n([^]*?)change only/.exec(readme);
  const members = [...stable.matchAll(/`(\w+)`/g)].map(([, name]) => name);
  assert.ok(members.includes('faceOffsets'), stable);
  const page = readFileSync(join(folder, 'made', 'examples', 'view.html'), 'utf8');
  const [, program] = /<script type="module">([^]*)<\/script>/.exec(page);
  writeFileSync(join(folder, 'made', 'examples', 'view.js'), program);
  writeFileSync(
    join(folder, 'stable.ts'),
    `import { load, Solver } from 'shape-up-engine';
    export const all: ('Solver' | keyof Solver)[] = ${JSON.stringify(members)};
    void load().then(() => new Solver());`,
  );
  assert.equal(typeErrors(folder, 'stable.ts', 'made/examples/view.js'), '');
});

const tunnel = at('..', 'shared', 'meshes', 'halftunnel.off');
const isThere = existsSync(tunnel);
const title = isThere ? 'the installed package solves the half tunnel' : 'there is no ../shared';
test(title, { skip: !isThere }, () => {
  assert.match(solve(tunnel), /All 784 panels are circular within /);
});

test('the example for pages draws the mesh while it is solved', async () => {
  const { address, close } = await serve(installed, { port: 0 });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: webgl2Flags,
  });
  try {
    const page = await browser.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    await page.goto(`${address}examples/view.html`);
    const canvas = page.locator('canvas');
    const empty = await canvas.screenshot();
    await page.getByLabel('Mesh').setInputFiles(join(folder, 'vault.obj'));
    await page.getByText(/^All 40 panels are circular within /).waitFor();
    assert.notDeepEqual(await canvas.screenshot(), empty);
    assert.deepEqual(complaints, []);
  } finally {
    await browser.close();
    close();
  }
});
