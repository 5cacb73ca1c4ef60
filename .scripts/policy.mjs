// The content security policy of the built pages, which holds them to what they say: nothing is loaded
// from elsewhere, nothing is sent anywhere, and no text becomes a script. A static host sends no
// headers, so it stands in each page; what is written into a page is allowed by its hash.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const INLINE = {
  script: /<script(?![^>]*\ssrc=)[^>]*>([\s\S]*?)<\/script>/g,
  style: /<style[^>]*>([\s\S]*?)<\/style>/g,
};
const HEAD = /<meta charset="utf-8" ?\/?>/;

/** As sources of a policy: what a page has of its own. */
function hashes(html, element) {
  const texts = [...html.matchAll(INLINE[element])].map(([, text]) => text);
  return texts.map((text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`);
}

/** The policy of a page. Workers have policies of their own, which no page can set. */
export function policyOf(html) {
  const directives = {
    'default-src': ["'none'"],
    'frame-src': ["'self'"],
    'script-src': ["'self'", "'wasm-unsafe-eval'", ...hashes(html, 'script')],
    'style-src': ["'self'", ...hashes(html, 'style')],
    'img-src': ["'self'"],
    'connect-src': ["'self'"],
    'worker-src': ["'self'"],
    'manifest-src': ["'self'"],
    'base-uri': ["'none'"],
    'form-action': ["'self'"],
  };
  return Object.entries(directives)
    .map((directive) => directive.flat().join(' '))
    .join('; ');
}

/** A page with its policy, before anything that it is about. */
export function locked(html) {
  if (!HEAD.test(html))
    throw new Error('A page has no <meta charset="utf-8"> to put its policy after');
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policyOf(html)}" />`;
  return html.replace(HEAD, (charset) => `${charset}\n    ${meta}`);
}

/** Locks all pages of the site in `folder`, when they are as they will be served. */
export function lockPages(folder) {
  const pages = readdirSync(folder).filter((name) => name.endsWith('.html'));
  for (const page of pages) {
    const path = join(folder, page);
    writeFileSync(path, locked(readFileSync(path, 'utf8')));
  }
}
