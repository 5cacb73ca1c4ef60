// Values that a screen shows more than once.

import type { Page } from '@playwright/test';

/**
 * Returns the measured values, with their units, that stand more than once among what is visible.
 * Left out are tables and diagrams, whose values belong to rows and axes, and what cannot be read
 * because a dialog or a menu lies above it.
 */
export const repeatedValues = (page: Page) => page.evaluate(repeated);

/** Runs in the page. */
function repeated() {
  const above = [...document.querySelectorAll('dialog[open], :popover-open')].at(-1);
  const seen = new Map<string, string[]>();
  const texts = document.createTreeWalker(above ?? document.body, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    const parent = text.parentElement;
    if (!parent?.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
    if (parent.closest('table, svg, canvas, script, style, select, .uplot')) continue;
    const words = (text.nodeValue ?? '').trim();
    for (const [value] of words.matchAll(/[\d.]+ (mm|m|ft|in|°|%)(?![a-z²³])|[\d\s]+ of \d\d+/gu)) {
      // Three digits of a value are hardly those of another one; round numbers are settings.
      const digits = value.replace(/\D/g, '').replace(/^0+/, '').replace(/0+$/, '');
      if (digits.length >= 3) seen.set(value.trim(), [...(seen.get(value.trim()) ?? []), words]);
    }
  }
  return [...seen]
    .filter(([, at]) => at.length > 1)
    .map(([value, at]) => `${value}: ${at.join(' | ')}`);
}
