/**
 * Offline use: the service worker (`service-worker.ts`) caches the built files. A new version is
 * fetched beside the old one and announced; it takes over when the user reloads. Of the view
 * module, only the variant that this browser draws with is cached, and of the pictures of the first
 * screen only the one that it showed. There is no service worker in development.
 */

import { isEmbedded } from '../ui/embedded.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';
import type { Startup } from './startup.ts';
import type { Viewport } from '../viewport/viewport.ts';

/**
 * Registers the service worker. Call this after the first picture is drawn, and again if the view
 * has changed to another backend.
 */
export function stayOffline(alerts: Alerts, startup: Startup, viewport: Viewport) {
  if (!import.meta.env.PROD || isEmbedded || !('serviceWorker' in navigator)) return;
  // `?nosw` disables the service worker for debugging.
  if (new URLSearchParams(location.search).has('nosw')) {
    void navigator.serviceWorker
      .getRegistration()
      .then((registration) => registration?.unregister());
    return;
  }
  register(alerts, startup, viewport).catch(() => {});
}

/** The address of the picture that the first screen shows, which is gone when the view has drawn. */
const picture = document.querySelector<HTMLImageElement>('#first-picture img')?.currentSrc;

let registered: Promise<ServiceWorkerRegistration> | null = null;

async function register(alerts: Alerts, startup: Startup, viewport: Viewport) {
  const { serviceWorker } = navigator;
  const isFirst = !registered;
  // Without a controller this is the first version, not a new one.
  const announce = (worker: ServiceWorker | null) => {
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
  const post = (worker: ServiceWorker | null) =>
    worker?.postMessage({ drawsWith: viewport.view?.backend(), picture });
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
