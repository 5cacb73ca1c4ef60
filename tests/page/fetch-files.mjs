// For tests of the page without a browser: `fetch` also reads files, such as the module of words.

import { readFileSync } from 'node:fs';

const { fetch } = globalThis;

globalThis.fetch = async (address, ...options) => {
  if (!(address instanceof URL) || address.protocol !== 'file:') return fetch(address, ...options);
  return new Response(readFileSync(address), { headers: { 'content-type': 'application/wasm' } });
};
