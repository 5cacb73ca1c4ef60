// The content security policy of the built pages, which enforces what they promise: nothing is
// loaded from or sent to other hosts, and no text becomes a script. A static host sends no headers,
// so each page contains its policy; inline scripts and styles are allowed by their hashes, also the
// style of the report of a build, whose document is shown in a frame that has the page's policy.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { at } from './project.mjs';

const INLINE = {
  script: /<script(?![^>]*\ssrc=)[^>]*>([\s\S]*?)<\/script>/g,
  style: /<style[^>]*>([\s\S]*?)<\/style>/g,
};
const HEAD = /<meta charset="utf-8" ?\/?>/;

const REPORT_STYLE = at('src', 'fabricate', 'report_page', 'page.css');

/** Returns the hash of an inline element's text, as a source of a policy. */
const hashOf = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** Returns the hashes of a page's inline elements. */
const hashes = (html, element) =>
  [...html.matchAll(INLINE[element])].map(([, text]) => hashOf(text));

/** Returns the policy of a page. Workers have policies of their own, which no page can set. */
export function policyOf(html) {
  const directives = {
    'default-src': ["'none'"],
    'script-src': ["'self'", "'wasm-unsafe-eval'", ...hashes(html, 'script')],
    'style-src': ["'self'", hashOf(readFileSync(REPORT_STYLE)), ...hashes(html, 'style')],
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

/** Returns a page with its policy, placed before everything that the policy governs. */
export function locked(html) {
  if (!HEAD.test(html))
    throw new Error('A page has no <meta charset="utf-8"> to put its policy after');
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policyOf(html)}" />`;
  return html.replace(HEAD, (charset) => `${charset}\n    ${meta}`);
}

/** Adds the policies to all pages of the site in `folder`; must be the last change to them. */
export function lockPages(folder) {
  const pages = readdirSync(folder).filter((name) => name.endsWith('.html'));
  for (const page of pages) {
    const path = join(folder, page);
    writeFileSync(path, locked(readFileSync(path, 'utf8')));
  }
}
