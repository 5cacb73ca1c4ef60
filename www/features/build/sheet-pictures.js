/** The sheets as they will be cut. A part that is pointed at lights up on the model, and the other way round. */

import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").SheetPicture} SheetPicture */

/**
 * @param {{ point: (panels: number[] | null) => void, choose: (panels: number[]) => void }} on
 */
export function sheetPictures({ point, choose }) {
  const place = element('div.sheets', { tabindex: '0', role: 'group', 'aria-label': 'Sheets' });
  /** The outlines of parts, each with its panels. @type {Map<Element, number[]>} */
  let outlines = new Map();
  /** @param {Event} event */
  const panelsAt = ({ target }) =>
    (target instanceof Element ? outlines.get(target) : undefined) ?? null;
  place.addEventListener('pointerover', (event) => point(panelsAt(event)));
  place.addEventListener('pointerleave', () => point(null));
  place.addEventListener('click', (event) => {
    const panels = panelsAt(event);
    if (panels) choose(panels);
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
          outline.setAttribute('data-panels', panels[k].join(' '));
          outline.classList.toggle(
            'failed',
            panels[k].some((panel) => failed.has(panel)),
          );
          outlines.set(outline, panels[k]);
        });
        // What lies above would take the pointer.
        for (const group of picture.querySelectorAll('g')) {
          group.setAttribute('class', group.id.toLowerCase());
          group.removeAttribute('id');
          if (group.className.baseVal !== 'cut') joinPaths(group);
        }
        // The name is engraved on the part.
        picture.querySelectorAll('.cut title').forEach((title) => title.remove());
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
    /** Marks the parts of which all panels are among these. @param {ReadonlySet<number>} panels */
    mark(panels) {
      const chosen = [...outlines].filter(([outline, own]) => {
        const is = own.length > 0 && own.every((panel) => panels.has(panel));
        outline.classList.toggle('chosen', is);
        return is;
      });
      if (chosen.length === 1) chosen[0][0].scrollIntoView({ block: 'nearest', inline: 'nearest' });
    },
  };
}

/**
 * Makes one path of those of a group: what looks at every element of a page has thousands less to look at.
 * @param {Element} group
 */
function joinPaths(group) {
  const [first, ...others] = group.querySelectorAll('path');
  if (!first) return;
  const all = [first, ...others].map((path) => path.getAttribute('d'));
  first.setAttribute('d', all.join(''));
  others.forEach((path) => path.remove());
}
