/**
 * Keeps the built files, so that the page opens without a network. Each version has a cache of its
 * own, filled completely before it is used; which files there are, and a name for them together, the
 * build puts before this text as `SITE`. Of the view's module, which is compiled for each backend, the
 * page says which one it draws with. The pictures of the gallery are kept when it is opened. What is
 * fetched later, such as the parts for Rhino, is kept when it was used once.
 */

/* global SITE */

const scope = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));
/** @type {{ version: string, files: string[], views: Record<string, string[]>, pictures: string[] }} */
// @ts-expect-error the build writes it above
const { version, files, views, pictures } = SITE;
/** What the gallery asks for first. */
const GALLERY = '/pictures/results.json';
const PREFIX = 'shape-up ';
const NAME = PREFIX + version;
/** The version before, whose pages may still be open. */
const KEPT = 2;

scope.addEventListener('install', (event) => event.waitUntil(fill()));
scope.addEventListener('activate', (event) => event.waitUntil(tidy()));
/** The view's module is being kept. */
let viewIsKept = Promise.resolve();
scope.addEventListener('message', (event) => {
  const { data } = event;
  if (data === 'take over') scope.skipWaiting();
  if (data.drawsWith) {
    // Whoever has no network keeps what is there.
    viewIsKept = keepMissing(views[data.drawsWith]).catch(() => {});
    event.waitUntil(viewIsKept);
  }
});
scope.addEventListener('fetch', (event) => {
  const { request } = event;
  const inScope = request.url.startsWith(scope.registration.scope);
  if (request.method !== 'GET' || !inScope) return;
  event.respondWith(answer(event));
  if (request.url.endsWith(GALLERY)) event.waitUntil(keepMissing(pictures).catch(() => {}));
});

/**
 * A host may let a browser keep old files for a while: those without a hash in their name must be of
 * this version.
 * @param {string} file
 */
const request = (file) =>
  new Request(file, { cache: file.startsWith('./assets/') ? 'default' : 'no-cache' });

async function fill() {
  const cache = await caches.open(NAME);
  await cache.addAll(files.map(request));
}

/** @param {string[]} wanted */
async function keepMissing(wanted) {
  const cache = await caches.open(NAME);
  const kept = await Promise.all(wanted.map((file) => cache.match(file)));
  await cache.addAll(wanted.filter((_, i) => !kept[i]).map(request));
}

async function tidy() {
  await viewIsKept;
  const names = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  const old = names.filter((name) => name !== NAME).slice(0, -(KEPT - 1));
  await Promise.all(old.map((name) => caches.delete(name)));
  await scope.clients.claim();
}

/**
 * From this version, else from the one before, else from the network.
 * @param {FetchEvent} event
 */
async function answer(event) {
  const { request } = event;
  const kept = await keptAnswer(request).catch(() => undefined);
  if (kept) return kept;
  const response = await fetch(request);
  if (response.ok && response.type === 'basic') {
    const copy = response.clone();
    // Storage that is full or switched off must not keep the answer of the network from the page.
    const keep = async () => (await caches.open(NAME)).put(request, copy);
    event.waitUntil(keep().catch(() => {}));
  }
  return response;
}

/** @param {Request} request */
async function keptAnswer(request) {
  const options = { ignoreSearch: request.mode === 'navigate' };
  const cache = await caches.open(NAME);
  return (await cache.match(request, options)) ?? caches.match(request, options);
}
