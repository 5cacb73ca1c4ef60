// How Vite bundles the page: www/ into dist/, with relative addresses, so that the site works
// from any sub-path of any static host.

import { cpSync, readFileSync } from 'node:fs';
import { minify } from 'vite';
import { firstPicture } from './examples.mjs';
import { at } from './project.mjs';

// Examples keep their names, because links to them are permanent.
const examples = {
  name: 'examples',
  apply: 'build',
  closeBundle: () => cpSync(at('www', 'examples'), at('dist', 'examples'), { recursive: true }),
};

const PLACE = '<!-- first picture -->';
const picture = {
  name: 'first-picture',
  async transformIndexHtml(html) {
    if (!html.includes(PLACE)) throw new Error(`index.html has no place for ${firstPicture}`);
    const { code } = await minify(
      'early-drag.js',
      readFileSync(at('www', 'early-drag.js'), 'utf8'),
    );
    const script = `<script>${code}</script>`;
    return html.replace(PLACE, () => readFileSync(firstPicture, 'utf8') + script);
  },
};

export default {
  root: at('www'),
  base: './',
  publicDir: false,
  plugins: [examples, picture],
  build: {
    outDir: at('dist'),
    emptyOutDir: true,
    target: 'es2022',
    // A module that is inlined as text cannot be compiled while it arrives.
    assetsInlineLimit: 0,
  },
  worker: { format: 'es' },
  server: { host: '127.0.0.1' },
};
