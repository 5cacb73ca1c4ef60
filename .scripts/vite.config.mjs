// How Vite bundles the page: www/ into dist/, with relative addresses, so that the site works
// from any sub-path of any static host.

import { cpSync } from 'node:fs';
import { at } from './project.mjs';

// Examples keep their names, because links to them are permanent.
const examples = {
  name: 'examples',
  apply: 'build',
  closeBundle: () => cpSync(at('www', 'examples'), at('dist', 'examples'), { recursive: true }),
};

export default {
  root: at('www'),
  base: './',
  publicDir: false,
  plugins: [examples],
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
