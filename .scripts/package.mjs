// npm run package: writes the engine as a package for pages and for Node, in dist/npm.

import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { licencesInText } from './licences-page.mjs';
import { at } from './project.mjs';
import { main, say } from './run.mjs';
import { setUp } from './setup.mjs';
import { writeSources } from './sources.mjs';
import { buildModules } from './wasm.mjs';

/** Of the module as wasm-bindgen writes it. */
const MODULE = ['shape_up.js', 'shape_up.d.ts', 'shape_up_bg.wasm'];

/** Writes the package of the engine that is built into a folder. */
export function writePackage(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const name of MODULE) copyFileSync(at('www', 'pkg', 'engine', name), join(folder, name));
  cpSync(at('.scripts', 'package'), folder, { recursive: true });
  copyFileSync(at('LICENSE'), join(folder, 'LICENSE'));
  writeFileSync(join(folder, 'licences.txt'), licencesInText());
  writeSources(join(folder, 'sources'));
  const { version, license, description } = JSON.parse(readFileSync(at('package.json'), 'utf8'));
  const about = {
    ...{ name: 'shape-up-engine', version, description, license, type: 'module' },
    ...{ types: 'index.d.ts', sideEffects: false },
    // A bundler for pages must not meet the modules of Node.
    exports: {
      '.': { types: './index.d.ts', node: './node.js', default: './index.js' },
      './shape_up_bg.wasm': './shape_up_bg.wasm',
    },
    engines: { node: '>=20.19' },
  };
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify(about, null, 2)}\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await setUp({ checks: false });
    await buildModules(['engine']);
    const folder = at('dist', 'npm');
    writePackage(folder);
    say(`the package is in ${folder}: npm install ${folder}`);
  });
}
