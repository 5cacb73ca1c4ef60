// The package of the engine, installed in an empty folder.

import test from 'node:test';
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { writePackage } from '../../.scripts/package.mjs';
import { at } from '../../.scripts/project.mjs';

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

test('the engine is packed, installed in an empty project, and solves', () => {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-package-'));
  const run = (command, ...words) =>
    execFileSync(command, words, { cwd: folder, encoding: 'utf8' });
  try {
    writePackage(join(folder, 'made'));
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
    writeFileSync(join(folder, 'package.json'), '{ "private": true }');
    run('npm', 'install', '--offline', '--no-audit', '--no-fund', `./${filename}`);
    writeFileSync(join(folder, 'vault.obj'), vault());
    const example = 'node_modules/shape-up-engine/examples/solve.mjs';
    const said = run('node', example, 'vault.obj', 'out.obj');
    assert.match(said, /All 40 panels are circular within /);
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
  } finally {
    rmSync(folder, { recursive: true });
  }
});
