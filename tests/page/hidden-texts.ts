// Texts that a person cannot read: under another element, cut off without an ellipsis, or in columns.

import type { Page } from '@playwright/test';

/**
 * The texts of labels, buttons, headings and terms in view whose last letter lies under something
 * else or outside of what their box shows, and those of buttons with pieces of text beside each other
 * as columns, each with its reason.
 */
export const hiddenTexts = (page: Page) =>
  page.evaluate(() => {
    const found: string[] = [];
    const isShown = (own: Element) =>
      own.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
      getComputedStyle(own).clipPath === 'none' &&
      !own.closest('.visually-hidden, [inert], svg');
    /** Whether the text ends in an ellipsis, or scrolls with what it is in. */
    const isShortened = (own: Element) => {
      for (let outer: Element | null = own; outer; outer = outer.parentElement) {
        const { textOverflow, overflowX, overflowY } = getComputedStyle(outer);
        if (textOverflow === 'ellipsis') return true;
        const { left, right, top, bottom } = outer.getBoundingClientRect();
        const { x, y } = end;
        // One that scrolls up and down may cut at its side.
        if (/auto|scroll/.test(overflowX) && (x < left || x > right)) return true;
        if (/auto|scroll/.test(overflowY) && (y < top || y > bottom)) return true;
      }
      return false;
    };
    let end = { x: 0, y: 0 };
    for (const own of document.querySelectorAll('label, button, summary, dt, th, legend, h2, h3')) {
      if (!isShown(own) || !(document.fullscreenElement ?? document).contains(own)) continue;
      const isRow =
        own.matches('button, summary') && /flex|grid/.test(getComputedStyle(own).display);
      const pieces = [...own.childNodes]
        .filter((one) => one.nodeType === Node.ELEMENT_NODE || one.nodeValue?.trim())
        .map((one) => one.nodeType === Node.TEXT_NODE);
      // Neighbouring pieces of text are one column.
      const columns = pieces.filter((isText, k) => isText && !pieces[k - 1]).length;
      if (isRow && columns > 1) found.push(`“${own.textContent}” is in ${columns} columns`);
      const texts = document.createTreeWalker(own, NodeFilter.SHOW_TEXT);
      for (let text = texts.nextNode(); text; text = texts.nextNode()) {
        const parent = text.parentElement;
        if (!parent || !text.textContent?.trim() || !isShown(parent)) continue;
        const range = document.createRange();
        range.selectNodeContents(text);
        const last = [...range.getClientRects()].filter(({ width }) => width > 3).pop();
        // What lets presses through is not found there.
        if (!last || getComputedStyle(parent).pointerEvents === 'none') continue;
        end = { x: last.right - 2, y: (last.top + last.bottom) / 2 };
        const isInWindow = end.x > 0 && end.x < innerWidth && end.y > 0 && end.y < innerHeight;
        if (!isInWindow || isShortened(parent)) continue;
        const top = document.elementFromPoint(end.x, end.y);
        if (!top || own.contains(top) || top.contains(own)) continue;
        // What is transparent, such as a link over a whole card, hides nothing.
        const { backgroundColor } = getComputedStyle(top);
        if (backgroundColor === 'rgba(0, 0, 0, 0)' && !top.matches('canvas, img, input')) continue;
        // What floats over the page as a whole: a dialog, a menu, a message.
        const layer = 'dialog, [popover], [role=alert], [role=dialog], [role=tooltip], .docked';
        if (top.closest(layer) !== own.closest(layer)) continue;
        found.push(`“${text.textContent.trim()}” is under ${top.outerHTML.slice(0, 80)}`);
      }
    }
    return [...new Set(found)];
  });
