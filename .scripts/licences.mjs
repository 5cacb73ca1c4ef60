// The shipped components and their licences: the crates of the WebAssembly modules, and the npm
// packages in the page's scripts. A licence not allowed here is an error, and so is a missing text.

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { at, wasmTarget } from './project.mjs';
import { outputOf, Problem } from './run.mjs';
import { modules } from './wasm.mjs';

/** Allowed for every component, most preferred first, with a pattern that recognises the text. */
const ALLOWED = {
  MIT: /Permission is hereby granted, free of charge/,
  Zlib: /provided .as-is.[\s\S]*altered source versions/i,
  ISC: /Permission to use, copy, modify,? and/,
  'BSD-2-Clause': /Redistribution and use in source and binary forms/,
  'BSD-3-Clause':
    /Redistribution and use in source and binary forms[\s\S]*(Neither the name|endorse)/,
  'Unicode-3.0': /UNICODE LICENSE V3/,
  'Apache-2.0': /Apache License,?\s+Version 2\.0/,
};
/** Allowed for single packages: the page of licences meets their conditions. */
export const EXCEPTIONS = { 'sprs-ldl': { 'LGPL-2.1': /GNU LESSER GENERAL PUBLIC LICENSE/ } };
/** The text for packages that name this licence but contain no text. */
const MIT = (authors) => `MIT License

Copyright (c) ${authors}

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.`;

/** The bundler, which adds a few lines of its own to the scripts. */
const BUNDLER = 'vite';

/**
 * @typedef {object} Component
 * @property {string} name
 * @property {string} version
 * @property {string} expression SPDX expression of its licences
 * @property {string} authors
 * @property {string | null} folder folder with its texts
 * @property {string} address address of its source
 */

/** Returns the crates compiled into the modules. @returns {Component[]} */
export function shippedCrates() {
  const features = ['--no-default-features', '--features', modules.join(',')];
  const options = ['--format-version', '1', '--filter-platform', wasmTarget, ...features];
  const { packages } = JSON.parse(cargo('metadata', ...options));
  // `cargo metadata` also lists crates that only tests need; the tree does not.
  const edges = ['--edges', 'normal,no-proc-macro', '--target', wasmTarget, ...features];
  const tree = cargo('tree', ...edges, '--prefix', 'none', '--format', '{p}').split('\n');
  const names = new Set(tree.map((line) => line.split(' ').slice(0, 2).join(' ')));
  return packages
    .filter(({ name, version, source }) => source && names.has(`${name} v${version}`))
    .map(({ name, version, license, authors, manifest_path: manifest }) => ({
      ...{ name, version, expression: license ?? '' },
      ...{ authors: authors.join(', ') || `the authors of ${name}`, folder: dirname(manifest) },
      address: `https://crates.io/crates/${name}/${version}`,
    }));
}

/** Returns the output of a Cargo command on the locked dependencies. */
function cargo(command, ...options) {
  const output = outputOf('cargo', [command, '--locked', ...options]);
  if (output === null)
    throw new Problem(`cargo ${command} failed, so the shipped crates are unknown`);
  return output;
}

/** Returns the npm packages that the page's scripts may contain. @returns {Component[]} */
export function shippedPackages() {
  const { packages } = JSON.parse(readFileSync(at('package-lock.json'), 'utf8'));
  return Object.entries(packages)
    .filter(([path, { dev, optional }]) => path && !dev && !optional)
    .map(([path]) => path)
    .concat(join('node_modules', BUNDLER))
    .map((path) => {
      const { name, version, license, author } = JSON.parse(
        readFileSync(at(path, 'package.json'), 'utf8'),
      );
      const authors = author?.name ?? author ?? `the authors of ${name}`;
      const address = `https://www.npmjs.com/package/${name}/v/${version}`;
      return { name, version, expression: license ?? '', authors, folder: at(path), address };
    });
}

/** The standard library, which every module contains. @returns {Component} */
export function standardLibrary() {
  const version = outputOf('rustc', ['--version'])?.split(' ')[1] ?? '';
  return {
    ...{ name: 'Rust standard library', version, expression: 'MIT OR Apache-2.0' },
    ...{ authors: 'The Rust Project Developers', folder: null },
    address: 'https://github.com/rust-lang/rust/tree/main/library',
  };
}

/** Returns the alternatives of an SPDX expression, as lists of licences. @returns {string[][]} */
export function alternatives(expression) {
  const tokens = expression.replaceAll('/', ' OR ').match(/[()]|[^\s()]+/g) ?? [];
  const either = () => {
    let all = both();
    while (tokens[0] === 'OR' && tokens.shift()) all = [...all, ...both()];
    return all;
  };
  const both = () => {
    let all = one();
    while (tokens[0] === 'AND' && tokens.shift()) {
      const others = one();
      all = all.flatMap((some) => others.map((more) => [...some, ...more]));
    }
    return all;
  };
  const one = () => {
    const token = tokens.shift();
    if (token !== '(') return [[token ?? '']];
    const inner = either();
    tokens.shift();
    return inner;
  };
  const all = either();
  // An exception to a licence (WITH) counts as another licence.
  return tokens.length > 0 ? [[expression]] : all;
}

/** Returns the licences used for a component. @param {Component} component @returns {string[]} */
export function licencesOf({ name, version, expression }) {
  const allowed = [...Object.keys(ALLOWED), ...Object.keys(EXCEPTIONS[name] ?? {})];
  const cost = (some) => Math.max(...some.map((id) => allowed.indexOf(id)));
  const possible = alternatives(expression).filter((some) =>
    some.every((id) => allowed.includes(id)),
  );
  if (possible.length === 0) {
    throw new Problem(
      `${name} ${version} is under "${expression}": allowed are ${allowed.join(', ')}. Remove it, or allow its licence in .scripts/licences.mjs and meet its terms.`,
    );
  }
  return possible.sort((a, b) => cost(a) - cost(b))[0];
}

/** Returns the licence texts of a component. @param {Component} component @returns {string[]} */
export function textsOf(component) {
  const { name, folder, authors } = component;
  const known = { ...ALLOWED, ...EXCEPTIONS[name] };
  const texts = (folder ? readdirSync(folder, { withFileTypes: true }) : [])
    .filter((entry) => entry.isFile() && /^(licen[cs]e|copying|notice)/i.test(entry.name))
    .map((entry) => ({ entry, text: readFileSync(join(folder, entry.name), 'utf8').trim() }));
  const notices = texts.filter(({ entry }) => /^notice/i.test(entry.name));
  const found = licencesOf(component).map((id) => {
    const own = texts.filter(({ text }) => known[id].test(text));
    const [shortest] = own.sort((a, b) => a.text.length - b.text.length);
    if (shortest) return shortest.text.split('\n# Licenses of bundled dependencies')[0];
    if (id === 'MIT') return MIT(authors);
    throw new Problem(
      `${name} is under ${id}, but ${folder} does not contain the text of that licence`,
    );
  });
  return [...found, ...notices.map(({ text }) => text)];
}

/** Returns all shipped components. */
export const shipped = () => [standardLibrary(), ...shippedCrates(), ...shippedPackages()];

/** Rejects a bundled module whose package is not among the shipped ones. */
export function assertLicensed(id) {
  const [, name] = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(id) ?? [];
  if (!name || shippedPackages().some((one) => one.name === name)) return;
  throw new Problem(
    `${name} is bundled but is no dependency: add it to the dependencies in package.json`,
  );
}
