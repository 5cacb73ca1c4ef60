// Texts that hardly differ from what is behind them.

import type { Page } from '@playwright/test';

/**
 * Those of the elements whose text has less contrast with the backgrounds of what contains it than WCAG
 * asks for (4.5, or 3 if it is large). Left out is what has a picture behind it.
 * @param selectors each of one element
 */
export const faintTexts = (page: Page, selectors: string[]) =>
  page.evaluate((selectors) => {
    const canvas = new OffscreenCanvas(1, 1);
    const pixel = canvas.getContext('2d', { willReadFrequently: true });
    if (!pixel) return [];
    /** The relative luminance of the pixel with these colours painted over each other. */
    const luminanceOf = (colours: string[]) => {
      for (const colour of ['Canvas', ...colours]) {
        pixel.fillStyle = colour;
        pixel.fillRect(0, 0, 1, 1);
      }
      const [r, g, b] = [...pixel.getImageData(0, 0, 1, 1).data].map((value) => {
        const part = value / 255;
        return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    return selectors.flatMap((selector) => {
      const own = document.querySelector(selector);
      if (!own) return [];
      const behind: string[] = [];
      for (let outer: Element | null = own; outer; outer = outer.parentElement) {
        const { backgroundColor, backgroundImage } = getComputedStyle(outer);
        if (backgroundImage !== 'none') return [];
        behind.unshift(backgroundColor);
      }
      const { color, fontSize, fontWeight } = getComputedStyle(own);
      const [low, high] = [luminanceOf(behind), luminanceOf([...behind, color])].sort(
        (a, b) => a - b,
      );
      const contrast = (high + 0.05) / (low + 0.05);
      const size = parseFloat(fontSize);
      const isLarge = size >= 24 || (size >= 18.66 && Number(fontWeight) >= 700);
      return contrast < (isLarge ? 3 : 4.5)
        ? [`contrast of ${contrast.toFixed(2)} at ${selector}: “${own.textContent?.trim()}”`]
        : [];
    });
  }, selectors);
