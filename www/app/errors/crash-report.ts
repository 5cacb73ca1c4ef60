/** Report of a failure, for the developers. */

import type { State, Store } from '../../store/state.ts';
import type { Alerts } from '../../ui/controls/alerts.ts';

/** @param what the error message */
export function crashReport(what: string, { model, document, numbers, renderer }: State) {
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
export async function copyReport(text: string, store: Store, alerts: Alerts) {
  try {
    await navigator.clipboard.writeText(text);
    store.set({ status: 'Report copied to the clipboard' });
  } catch {
    alerts.notice(text);
  }
}
