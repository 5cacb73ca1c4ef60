/**
 * The page without a network: the service worker keeps the built files (`service-worker.js`). A new
 * version is fetched beside the old one and announced; it takes over when somebody says so. While the
 * page is developed there is no service worker.
 */

/**
 * @param {import("./alerts.js").Alerts} alerts
 * @param {import("./keeping.js").Keeping} keeping
 */
export function stayOffline(alerts, keeping) {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  // Whoever looks for a fault can do without.
  if (new URLSearchParams(location.search).has('nosw')) {
    navigator.serviceWorker.getRegistration().then((registration) => registration?.unregister());
    return;
  }
  const start = () => register(alerts, keeping).catch(() => {});
  // After what the first picture needs.
  if (document.readyState === 'complete') start();
  else window.addEventListener('load', start);
}

/**
 * @param {import("./alerts.js").Alerts} alerts
 * @param {import("./keeping.js").Keeping} keeping
 */
async function register(alerts, keeping) {
  const { serviceWorker } = navigator;
  // The first one of all is not a new version.
  const announce = (/** @type {ServiceWorker | null} */ worker) => {
    if (!worker || !serviceWorker.controller) return;
    alerts.notice('A new version of Shape-Up is here. Your work is kept.', {
      label: 'Reload',
      action: async () => {
        await keeping.saveNow().catch(() => {});
        serviceWorker.addEventListener('controllerchange', () => location.reload());
        worker.postMessage('take over');
      },
    });
  };
  const address = new URL(/* @vite-ignore */ 'service-worker.js', document.baseURI);
  const registration = await serviceWorker.register(address, { updateViaCache: 'none' });
  announce(registration.waiting);
  registration.addEventListener('updatefound', () => {
    const worker = registration.installing;
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'installed') announce(worker);
    });
  });
}
