// Configuration of Vite: www/ into dist/, with relative addresses, so that the site works from any
// sub-path of any static host.

import { cpSync, readFileSync, statSync } from 'node:fs';
import { relative } from 'node:path';
import { minify } from 'vite';
import { escaped, licenceTexts } from './licences-page.mjs';
import { assertLicensed } from './licences.mjs';
import { writeOfflineParts } from './offline.mjs';
import { lockPages } from './policy.mjs';
import { at } from './project.mjs';
import { speedTexts } from './speed-page.mjs';

/** The pictures of the first screen, which `index.html` has already. */
const FIRST = /[\\/]first-[^\\/]*$/;
/** The script for Rhino and Grasshopper. */
const SCRIPT = ['rhino', 'shape_up.py'];
// Examples, their pictures and the script keep their names, because links to them are permanent.
const examples = {
  name: 'examples',
  apply: 'build',
  async closeBundle() {
    for (const folder of ['examples', 'pictures']) {
      const filter = (path) => !FIRST.test(path);
      cpSync(at('www', folder), at('dist', folder), { recursive: true, filter });
    }
    cpSync(at('www', ...SCRIPT), at('dist', ...SCRIPT));
    lockPages(at('dist'));
    await writeOfflineParts(at('dist'));
  },
};

/** Removes the indentation of pages and minifies their inline scripts. */
const smallPages = {
  name: 'small-pages',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    async handler(html) {
      // Licence texts keep their whitespace.
      const outdented = html.includes('<pre>') ? html : html.replace(/\n\s+/g, '\n');
      const pieces = outdented.split(/(?<=<script>)([\s\S]*?)(?=<\/script>)/);
      const small = pieces.map(async (piece, i) =>
        i % 2 ? (await minify('inline.js', piece)).code.trim() : piece,
      );
      return (await Promise.all(small)).join('');
    },
  },
};

/** Inserts the common head of the reading pages, their links with the current page marked, and the script. */
const readingPages = {
  name: 'reading-pages',
  transformIndexHtml: {
    order: 'pre',
    handler(html, { path }) {
      const part = (name) => readFileSync(at('www', 'pages', `${name}.html`), 'utf8');
      const link = `href=".${path}"`;
      return html
        .replace('<!-- reading head -->', () => part('reading-head'))
        .replace('<!-- reading header -->', () =>
          part('reading-header').replace(link, `${link} aria-current="page"`),
        )
        .replace('<!-- shape_up.py -->', () =>
          escaped(readFileSync(at('www', ...SCRIPT), 'utf8').trim()),
        );
    },
  },
};

/** Fills the page of licences with those of everything bundled. */
const licences = {
  name: 'licences',
  transformIndexHtml: (html, { path }) => (path === '/licences.html' ? licenceTexts(html) : html),
};
/** Fills the page about speed with what was measured. */
const speed = {
  name: 'speed',
  transformIndexHtml: (html, { path }) => (path === '/speed.html' ? speedTexts(html) : html),
};
const onlyLicensed = () => ({
  name: 'only-licensed',
  moduleParsed: ({ id }) => assertLicensed(id),
});

/**
 * Cascade layers by room: a style sheet is in the layer of its room, so that it never overrules
 * higher rooms, whatever its selectors and its time of loading. Libraries are lowest; the frame of
 * the page is below its contents.
 */
const LAYERS = ['library', 'ui', 'app', 'panels', 'docked', 'features', 'pages'];
/** Design tokens with a constant pixel value are inlined, which makes the styles smaller. */
const constants = Object.fromEntries(
  [
    ...readFileSync(at('www', 'ui', 'styles', 'base.css'), 'utf8').matchAll(
      /^\s*(--[\w-]+): (\d+px);/gm,
    ),
  ].map(([, name, value]) => [name, value]),
);
const layers = {
  name: 'layers',
  enforce: 'pre',
  transform(code, id) {
    if (!/\.css($|\?)/.test(id)) return null;
    const room = /^(\w+)[\\/]/.exec(relative(at('www'), id))?.[1] ?? 'library';
    if (!LAYERS.includes(room)) throw new Error(`${id}: ${room}/ belongs to no layer`);
    // Whichever style sheet comes first declares the order of the layers.
    const plain = code.replace(/var\((--[\w-]+)\)/g, (use, name) => constants[name] ?? use);
    return `@layer ${LAYERS.join(', ')};\n@layer ${room} {\n${plain}\n}`;
  },
};

/** The pages of the site. */
const pages = ['index', 'gallery', 'licences', 'checked', 'speed', 'rhino', 'teaching', 'embed'];

const documents = pages.map((page) => at('www', `${page}.html`));
/**
 * Left out of chunks, so that the document has one script: of an entry that only imports, Vite makes a
 * script for each import, and in WebKit a script does not wait for another that awaits its module
 * (https://bugs.webkit.org/show_bug.cgi?id=242740).
 */
const ENTRIES = [documents[0], at('www', 'app', 'main.ts')];
/**
 * Returns the name of the first-visit chunk of a module, if any: `workbench` for modules that only
 * the workbench starts with, `common` for those that another page starts with as well. Modules
 * shared with other pages would otherwise be several files, which compress worse. `words` is a file of
 * its own: who imports nothing of it, as the poster of an embedded view, does not wait for its module.
 * @param {string} id
 * @param {{ getModuleInfo(id: string): { importedIds: readonly string[] } | null }} graph
 */
function firstFile(id, graph) {
  if (/[\\/](ui[\\/]words\.ts|pkg[\\/]words[\\/])/.test(id)) return 'words';
  if (ENTRIES.includes(id)) return null;
  const [workbench, ...others] = documents.map((document) => begunWith(document, graph));
  if (!workbench.has(id)) return null;
  return others.some((other) => other.has(id)) ? 'common' : 'workbench';
}

/** @type {Map<string, Set<string>>} */
const begun = new Map();
/** Returns the modules that a page imports statically. */
function begunWith(document, graph) {
  const known = begun.get(document);
  if (known) return known;
  const found = new Set([document]);
  for (const id of found)
    for (const imported of graph.getModuleInfo(id)?.importedIds ?? []) found.add(imported);
  begun.set(document, found);
  return found;
}

/** Size of the engine's module, for its progress display. */
const engineBytes = statSync(at('www', 'pkg', 'engine', 'shape_up_bg.wasm')).size;

/** The version of the program; a test compares it with the command line's. */
const { version } = JSON.parse(readFileSync(at('package.json'), 'utf8'));

// wasm-bindgen gives the files of all modules the same names: use the module's folder name.
const moduleOf = (path) => /\/?pkg\/([\w-]+)\//.exec(path ?? '')?.[1] ?? '[name]';
// Short hashes, as hashes do not compress.
const output = {
  entryFileNames: 'assets/[name]-[hash:7].js',
  chunkFileNames: ({ facadeModuleId }) => `assets/${moduleOf(facadeModuleId)}-[hash:7].js`,
  assetFileNames: ({ originalFileNames: [path] }) => `assets/${moduleOf(path)}-[hash:7][extname]`,
};

export default {
  root: at('www'),
  base: './',
  define: {
    'import.meta.env.ENGINE_BYTES': String(engineBytes),
    'import.meta.env.VERSION': JSON.stringify(version),
  },
  publicDir: false,
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  plugins: [layers, examples, readingPages, licences, speed, smallPages, onlyLicensed()],
  build: {
    outDir: at('dist'),
    emptyOutDir: true,
    target: 'es2022',
    // A module inlined as text could not be compiled while it is downloaded.
    assetsInlineLimit: 0,
    rolldownOptions: {
      input: documents,
      output: {
        ...output,
        codeSplitting: { groups: [{ name: firstFile, debugName: 'first visit' }] },
      },
    },
  },
  // The same names, so that a file loaded by both page and worker exists once.
  worker: { format: 'es', plugins: () => [onlyLicensed()], rolldownOptions: { output } },
  server: { host: '127.0.0.1' },
};
