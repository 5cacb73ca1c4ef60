/** Shows uncaught errors, and offers to copy a report. */

import { messageOf } from '../../solver/messages.js';

/** Browsers report this if a size changes twice within a frame; it is not an error. */
const HARMLESS = /^ResizeObserver loop/;

/**
 * @param {import("../../ui/controls/alerts.js").Alerts} alerts
 * @param {import("../../store/state.js").Store} store
 */
export function reportUncaughtErrors(alerts, store) {
  const report = (/** @type {unknown} */ thrown) => {
    const message = `Something went wrong on this page: ${messageOf(thrown)}`;
    alerts.error(message, offerReport(message, store, alerts));
  };
  window.addEventListener('error', ({ error, message }) => {
    if (!HARMLESS.test(message)) report(error ?? message);
  });
  window.addEventListener('unhandledrejection', ({ reason }) => report(reason));
}

/**
 * Returns the button of an error message that copies a report for the developers.
 * @param {string} message
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../ui/controls/alerts.js").Alerts} alerts
 */
export function offerReport(message, store, alerts) {
  const action = async () => {
    const { crashReport, copyReport } = await import('./crash-report.js');
    await copyReport(crashReport(message, store.get()), store, alerts);
  };
  return { label: 'Copy report', action };
}
