/** How many types of parts there are at each tolerance, as bars; a press takes that tolerance. */

import { element, setText } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import { millimetres } from './check-card.js';

/** @typedef {import("../../solver/messages.js").BuildReport} BuildReport */
/** @typedef {import("../../solver/messages.js").BuildSettings} BuildSettings */

/** @param {(change: Partial<BuildSettings>) => void} change */
export function typesCurve(change) {
  const title = element('span', { id: 'parts-types' });
  const bars = element('div.type-bars', { role: 'group', 'aria-labelledby': 'parts-types' });
  const words = element('p.quiet');
  const joint = element('p.quiet');
  const place = element('div.types-curve', title, bars, words, joint);
  return {
    place,
    /**
     * @param {BuildReport} report
     * @param {BuildSettings} settings
     */
    update(report, settings) {
      const { frame, product, least_joint_mm: least } = report;
      const curve = frame?.node_types_curve ?? report.types_curve;
      const taken = frame ? settings.alike_deg : settings.alike;
      const total = frame ? frame.nodes : report.panels;
      place.hidden = product === 'paper' || curve.length === 0;
      setText(
        title,
        frame ? 'Types of nodes alike within, degrees' : 'Types of panels alike within, mm',
      );
      bars.replaceChildren(
        ...curve.map(([at, types]) => {
          const within = frame ? `${at}\u00b0` : `${at} mm`;
          const bar = element('span.bar');
          bar.style.height = `${(100 * types) / Math.max(total, 1)}%`;
          return element(
            'button',
            {
              'aria-label': `${count(types, 'type')} within ${within}`,
              'aria-pressed': String(at === taken),
              onclick: () => change(frame ? { alike_deg: at } : { alike: at }),
            },
            element('span.column', bar),
            element('span', String(types)),
            element('span.quiet', String(at)),
          );
        }),
      );
      setText(words, `${count(report.edge_types, 'type')} of edges within ${settings.alike} mm.`);
      const [outside, inside] = least.map((mm) => (mm === null ? 'none' : millimetres(mm)));
      joint.hidden = product !== 'panels' || settings.thickness === 0;
      setText(
        joint,
        `Least joint on the sheet at ${millimetres(settings.thickness)}: ${outside} for panels outside of the surface, ${inside} inside.`,
      );
    },
  };
}
