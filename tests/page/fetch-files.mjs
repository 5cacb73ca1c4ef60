// For tests of the page without a browser: `fetch` also reads files, as the page's module of words is.

import { readFileSync } from 'node:fs';

const { fetch } = globalThis;

globalThis.fetch = async (address, ...options) => {
  if (new URL(address).protocol !== 'file:') return fetch(address, ...options);
  return new Response(readFileSync(address), { headers: { 'content-type': 'application/wasm' } });
};
