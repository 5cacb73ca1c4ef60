/** Shows uncaught errors, and offers to copy a report. */

import { messageOf } from '../../solver/errors.ts';
import { copyReport, crashReport } from './crash-report.ts';
import type { Alerts } from '../../ui/controls/alerts.ts';
import type { Store } from '../../store/state.ts';

/** Browsers report this if a size changes twice within a frame; it is not an error. */
const HARMLESS = /^ResizeObserver loop/;

export function reportUncaughtErrors(alerts: Alerts, store: Store) {
  const report = (thrown: unknown) => {
    const message = `Something went wrong on this page: ${messageOf(thrown)}`;
    alerts.error(message, offerReport(message, store, alerts));
  };
  window.addEventListener('error', ({ error, message }) => {
    if (!HARMLESS.test(message)) report(error ?? message);
  });
  window.addEventListener('unhandledrejection', ({ reason }) => report(reason));
}

/** Returns the button of an error message that copies a report for the developers. */
export function offerReport(message: string, store: Store, alerts: Alerts) {
  const action = () => copyReport(crashReport(message, store.get()), store, alerts);
  return { label: 'Copy report', action };
}
