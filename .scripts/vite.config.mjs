// How Vite bundles the page: www/ into dist/, with relative addresses, so that the site works
// from any sub-path of any static host.

import { cpSync, readFileSync, statSync } from 'node:fs';
import { minify } from 'vite';
import { firstPicture } from './examples.mjs';
import { licenceTexts } from './licences-page.mjs';
import { assertTold } from './licences.mjs';
import { writeOfflineParts } from './offline.mjs';
import { lockPages } from './policy.mjs';
import { at } from './project.mjs';

// Examples and their pictures keep their names, because links to them are permanent.
const examples = {
  name: 'examples',
  apply: 'build',
  closeBundle() {
    for (const folder of ['examples', 'pictures']) {
      cpSync(at('www', folder), at('dist', folder), { recursive: true });
    }
    lockPages(at('dist'));
    writeOfflineParts(at('dist'));
  },
};

const PLACE = '<!-- first picture -->';
const picture = {
  name: 'first-picture',
  transformIndexHtml(html, { path }) {
    if (path !== '/index.html') return html;
    if (!html.includes(PLACE)) throw new Error(`index.html has no place for ${firstPicture}`);
    const script = `<script>${readFileSync(at('www', 'viewport', 'placeholder', 'placeholder-drag.js'), 'utf8')}</script>`;
    return html.replace(PLACE, () => readFileSync(firstPicture, 'utf8') + script);
  },
};

/** Pages are not indented, and the scripts that stand in them are as small as the others. */
const smallPages = {
  name: 'small-pages',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    async handler(html) {
      // The texts of licences are laid out by their spaces.
      const outdented = html.includes('<pre>') ? html : html.replace(/\n\s+/g, '\n');
      const pieces = outdented.split(/(?<=<script>)([\s\S]*?)(?=<\/script>)/);
      const small = pieces.map(async (piece, i) =>
        i % 2 ? (await minify('inline.js', piece)).code.trim() : piece,
      );
      return (await Promise.all(small)).join('');
    },
  },
};

/** What the pages to read have in common: their head, and the links above them, of which one is the page. */
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
        );
    },
  },
};

/** Whatever is bundled has its licence on the page of licences. */
const licences = {
  name: 'licences',
  transformIndexHtml: (html, { path }) => (path === '/licences.html' ? licenceTexts(html) : html),
};
const told = () => ({
  name: 'told',
  moduleParsed: ({ id }) => assertTold(id),
});

/**
 * A style sheet is in the layer of its room, so that none overrules those above it whatever its
 * selectors are, and whenever it is loaded. What libraries bring is below all; the frame of the page
 * is below what fills it.
 */
const LAYERS = ['library', 'ui', 'app', 'panels', 'docked', 'features', 'pages'];
/** Tokens that are the same everywhere are written out: they cost nobody a byte. */
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
    const room = /\/www\/(\w+)\//.exec(id)?.[1] ?? 'library';
    if (!LAYERS.includes(room)) throw new Error(`${id}: no layer is that of ${room}/`);
    // Whichever comes first says the order.
    const plain = code.replace(/var\((--[\w-]+)\)/g, (use, name) => constants[name] ?? use);
    return `@layer ${LAYERS.join(', ')};\n@layer ${room} {\n${plain}\n}`;
  },
};

/** The pages of the site. */
const pages = ['index', 'gallery', 'projections', 'licences', 'embed', 'embedding'];

const documents = pages.map((page) => at('www', `${page}.html`));
/**
 * Of which file of the first visit a module is, if of any: what the workbench begins with is one file, and
 * what the other pages begin with as well is another. Modules that are shared with what comes later would
 * otherwise be a file each, which pack worse than together.
 * @param {string} id
 * @param {{ getModuleInfo(id: string): { importedIds: readonly string[] } | null }} graph
 */
function firstFile(id, graph) {
  const [workbench, ...others] = documents.map((document) => begunWith(document, graph));
  if (!workbench.has(id)) return null;
  return others.some((other) => other.has(id)) ? 'common' : 'workbench';
}

/** @type {Map<string, Set<string>>} */
const begun = new Map();
/** The modules that a page loads at once. */
function begunWith(document, graph) {
  const known = begun.get(document);
  if (known) return known;
  const found = new Set([document]);
  for (const id of found)
    for (const imported of graph.getModuleInfo(id)?.importedIds ?? []) found.add(imported);
  begun.set(document, found);
  return found;
}

/** What is told of the solver's module while it loads. */
const solverBytes = statSync(at('www', 'pkg', 'solver', 'shape_up_bg.wasm')).size;

// Files of a wasm module are named for it: every module calls them the same.
const moduleOf = (path) => /\/?pkg\/([\w-]+)\//.exec(path ?? '')?.[1] ?? '[name]';
// A hundred files are named in the first visit, where hashes do not pack.
const output = {
  entryFileNames: 'assets/[name]-[hash:7].js',
  chunkFileNames: ({ facadeModuleId }) => `assets/${moduleOf(facadeModuleId)}-[hash:7].js`,
  assetFileNames: ({ originalFileNames: [path] }) => `assets/${moduleOf(path)}-[hash:7][extname]`,
};

export default {
  root: at('www'),
  base: './',
  define: { 'import.meta.env.SOLVER_BYTES': String(solverBytes) },
  publicDir: false,
  plugins: [layers, examples, picture, readingPages, licences, smallPages, told()],
  build: {
    outDir: at('dist'),
    emptyOutDir: true,
    target: 'es2022',
    // A module that is inlined as text cannot be compiled while it arrives.
    assetsInlineLimit: 0,
    rolldownOptions: {
      input: documents,
      output: {
        ...output,
        codeSplitting: { groups: [{ name: firstFile, debugName: 'first visit' }] },
      },
    },
  },
  // The same names: what the page and a worker both load is one file.
  worker: { format: 'es', plugins: () => [told()], rolldownOptions: { output } },
  server: { host: '127.0.0.1' },
};
