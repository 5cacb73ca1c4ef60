/**
 * Offline use: the service worker (`service-worker.js`) caches the built files. A new version is
 * fetched beside the old one and announced; it takes over when the user reloads. Of the view
 * module, only the variant that this browser draws with is cached. There is no service worker in
 * development.
 */

import { isEmbedded } from '../../ui/embedded.js';

/**
 * Registers the service worker. Call this after the first picture is drawn, and again if the view
 * has changed to another backend.
 * @param {import("../../ui/controls/alerts.js").Alerts} alerts
 * @param {import("../startup.js").Startup} startup
 * @param {import("../../viewport/viewport.js").Viewport} viewport
 */
export function stayOffline(alerts, startup, viewport) {
  if (!import.meta.env.PROD || isEmbedded || !('serviceWorker' in navigator)) return;
  // `?nosw` disables the service worker for debugging.
  if (new URLSearchParams(location.search).has('nosw')) {
    navigator.serviceWorker.getRegistration().then((registration) => registration?.unregister());
    return;
  }
  register(alerts, startup, viewport).catch(() => {});
}

/** @type {Promise<ServiceWorkerRegistration> | null} */
let registered = null;

/**
 * @param {import("../../ui/controls/alerts.js").Alerts} alerts
 * @param {import("../startup.js").Startup} startup
 * @param {import("../../viewport/viewport.js").Viewport} viewport
 */
async function register(alerts, startup, viewport) {
  const { serviceWorker } = navigator;
  const isFirst = !registered;
  // Without a controller this is the first version, not a new one.
  const announce = (/** @type {ServiceWorker | null} */ worker) => {
    if (!worker || !serviceWorker.controller) return;
    alerts.notice('A new version of Shape-Up is available. Your work is kept.', {
      label: 'Reload',
      action: async () => {
        await startup.saveNow().catch(() => {});
        serviceWorker.addEventListener('controllerchange', () => location.reload());
        worker.postMessage('take over');
      },
    });
  };
  const address = new URL(/* @vite-ignore */ 'service-worker.js', document.baseURI);
  registered ??= serviceWorker.register(address, { updateViaCache: 'none' });
  const registration = await registered;
  const post = (/** @type {ServiceWorker | null} */ worker) =>
    worker?.postMessage({ drawsWith: viewport.view?.backend() });
  for (const stage of [registration.installing, registration.waiting, registration.active])
    post(stage);
  if (!isFirst) return;
  announce(registration.waiting);
  registration.addEventListener('updatefound', () => {
    const worker = registration.installing;
    post(worker);
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'installed') announce(worker);
    });
  });
}
