/** A picture without a ground, from the same picture on white and on black. */

/** So many rows are read at once: of a large picture all would be too much. */
const ROWS = 256;

/**
 * What covers a part `a` of a pixel in the colour `c` is `a c + 1 - a` on white and `a c` on black: their difference is
 * what shows through. Leaves the picture in `onBlack`.
 * @param {CanvasRenderingContext2D} onBlack
 * @param {CanvasRenderingContext2D} onWhite
 */
export function cutOut(onBlack, onWhite) {
  const { width, height } = onBlack.canvas;
  for (let top = 0; top < height; top += ROWS) {
    const rows = Math.min(ROWS, height - top);
    const picture = onBlack.getImageData(0, top, width, rows);
    const black = picture.data;
    const white = onWhite.getImageData(0, top, width, rows).data;
    for (let at = 0; at < black.length; at += 4) {
      const through = white[at] + white[at + 1] + white[at + 2];
      const own = black[at] + black[at + 1] + black[at + 2];
      const covered = Math.min(Math.max(1 - (through - own) / 765, 0), 1);
      for (let i = at; i < at + 3; i++) black[i] = covered > 0 ? black[i] / covered : 0;
      black[at + 3] = Math.round(255 * covered);
    }
    onBlack.putImageData(picture, 0, top);
  }
}
