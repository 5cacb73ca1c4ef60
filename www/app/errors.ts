/** Uncaught errors, and the report about one for the developers. */

import { messageOf } from '../solver/errors.ts';
import { copyText } from '../ui/output.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';
import type { Store, State } from '../store/state.ts';

/** Browsers report this if a size changes twice within a frame; it is not an error. */
const HARMLESS = /^ResizeObserver loop/;

/** Shows uncaught errors, and offers to copy a report. */
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

/** @param what the error message */
function crashReport(what: string, { model, document, numbers, renderer }: State) {
  const rows = (document?.constraints ?? []).map(
    ({ kind, count, weight, enabled }) =>
      `  ${kind}: ${count}, weight ${weight}${enabled ? '' : ', off'}`,
  );
  return [
    'Shape-Up',
    what,
    `Model: ${model?.vertices ?? 0} vertices, ${model?.faces ?? 0} faces, ${model?.curves ?? 0} curves, ${model?.tets ?? 0} tetrahedra`,
    `Constraints:${rows.length > 0 ? '' : ' none'}`,
    ...rows,
    `Handles: ${document?.handles.length ?? 0}`,
    `Iteration: ${numbers?.iteration ?? 0}`,
    `Renderer: ${renderer}`,
    `Page: ${location.href.split('#')[0]}`,
    `Browser: ${navigator.userAgent}`,
    `Time: ${new Date().toISOString()}`,
  ].join('\n');
}

/** Copies the report to the clipboard, or shows it if copying is not allowed. */
async function copyReport(text: string, store: Store, alerts: Alerts) {
  const isCopied = (await copyText(text, '')) !== '';
  if (isCopied) store.set({ status: 'Report copied to the clipboard' });
  else alerts.notice(text);
}
