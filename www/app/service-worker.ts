/**
 * Service worker: caches the built files, so that the page opens without a network. Each version
 * has its own cache, filled completely before it is used. The build prepends the list of files and
 * their version as `SITE`. The view module is compiled for each backend; the page reports which one
 * it draws with, and the picture that it showed first. The pictures of the gallery are cached when
 * it is opened. Files fetched later, such as the parts for Rhino, are cached after their first use.
 */

const scope = self as unknown as ServiceWorkerGlobalScope;

/** The built files, by what needs them. */
interface Site {
  version: string;
  files: string[];
  views: Record<string, string[]>;
  pictures: string[];
}
declare const SITE: Site;
const { version, files, views, pictures } = SITE;
/** The first file that the gallery requests. */
const GALLERY = '/pictures/results.json';
const PREFIX = 'shape-up ';
const NAME = PREFIX + version;
/** Number of versions kept: the previous one may still be open in other tabs. */
const KEPT = 2;

scope.addEventListener('install', (event) => event.waitUntil(fill()));
scope.addEventListener('activate', (event) => event.waitUntil(tidy()));
/** Resolves when the view module is cached. */
let viewIsKept = Promise.resolve();
scope.addEventListener('message', (event) => {
  const { data } = event;
  if (data === 'take over') void scope.skipWaiting();
  if (data.drawsWith) {
    // Without a network the cached files stay as they are.
    // By itself: of a new version the picture may have another name, and the view must be kept.
    const picture = data.picture ? keepMissing([data.picture]).catch(() => {}) : null;
    const view = keepMissing(views[data.drawsWith]).catch(() => {});
    viewIsKept = Promise.all([view, picture]).then(() => {});
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
 * Bypasses the HTTP cache for files without a hash in the name, since a host may let browsers cache
 * old versions of them.
 */
const request = (file: string) =>
  new Request(file, { cache: file.startsWith('./assets/') ? 'default' : 'no-cache' });

async function fill() {
  const cache = await caches.open(NAME);
  await cache.addAll(files.map(request));
}

async function keepMissing(wanted: string[]) {
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

/** Answers from the cache of this version, else of the previous one, else from the network. */
async function answer(event: FetchEvent) {
  const { request } = event;
  const kept = await keptAnswer(request).catch(() => undefined);
  if (kept) return kept;
  const response = await fetch(request);
  if (response.ok && response.type === 'basic') {
    const copy = response.clone();
    // The response reaches the page even if storage is full or disabled.
    const keep = async () => (await caches.open(NAME)).put(request, copy);
    event.waitUntil(keep().catch(() => {}));
  }
  return response;
}

async function keptAnswer(request: Request) {
  const options = { ignoreSearch: request.mode === 'navigate' };
  const cache = await caches.open(NAME);
  return (await cache.match(request, options)) ?? caches.match(request, options);
}
