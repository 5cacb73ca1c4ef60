/** The sheets as they will be cut. A part that is pointed at lights up on the model, and the other way round. */

import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").SheetPicture} SheetPicture */

/**
 * @param {{ point: (panel: number | null) => void, choose: (panel: number) => void }} on
 */
export function sheetPictures({ point, choose }) {
  const place = element('div.sheets', { tabindex: '0', role: 'group', 'aria-label': 'Sheets' });
  /** The outlines of each panel. @type {Map<number, Element>} */
  let outlines = new Map();
  /** @param {Event} event */
  const panelAt = ({ target }) => {
    const panel = target instanceof Element && target.getAttribute('data-panel');
    return panel ? Number(panel) : null;
  };
  place.addEventListener('pointerover', (event) => point(panelAt(event)));
  place.addEventListener('pointerleave', () => point(null));
  place.addEventListener('click', (event) => {
    const panel = panelAt(event);
    if (panel !== null) choose(panel);
  });
  return {
    place,
    /**
     * @param {SheetPicture[]} sheets
     * @param {ReadonlySet<number>} failed panels that are not within their limit
     * @param {number} more that are not shown
     */
    show(sheets, failed, more) {
      outlines = new Map();
      const figures = sheets.map(({ name, svg, panels, failed: sides }) => {
        const picture = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
        for (const attribute of ['width', 'height']) picture.removeAttribute(attribute);
        picture.setAttribute('role', 'img');
        picture.setAttribute('aria-label', name);
        const cut = picture.querySelectorAll('#CUT > path');
        cut.forEach((outline, k) => {
          outline.setAttribute('data-panel', String(panels[k]));
          outline.classList.toggle('failed', failed.has(panels[k]));
          outlines.set(panels[k], outline);
        });
        // What lies above would take the pointer.
        for (const group of picture.querySelectorAll('g')) {
          group.setAttribute('class', group.id.toLowerCase());
          group.removeAttribute('id');
        }
        for (const outline of cut) outline.removeAttribute('id');
        if (sides) {
          const marks = document.createElementNS(picture.namespaceURI, 'path');
          marks.setAttribute('class', 'failed-sides');
          marks.setAttribute('d', sides);
          picture.append(marks);
        }
        return element('figure', picture, element('figcaption', name));
      });
      const rest = more > 0 ? [element('p.quiet', `and ${more} more`)] : [];
      place.replaceChildren(...figures, ...rest);
    },
    /** Marks the parts of these panels. @param {ReadonlySet<number>} panels */
    mark(panels) {
      for (const [panel, outline] of outlines)
        outline.classList.toggle('chosen', panels.has(panel));
      const [first] = panels;
      if (panels.size === 1)
        outlines.get(first)?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    },
  };
}
