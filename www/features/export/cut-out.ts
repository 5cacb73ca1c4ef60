/** A picture with transparency, from the same picture on white and on black. */

/** Rows read at once, to limit the memory for a large picture. */
const ROWS = 256;

/**
 * A colour `c` with coverage `a` gives `a c + 1 - a` on white and `a c` on black, so their
 * difference is the transparency `1 - a`. Writes the result to `onBlack`.
 */
export function cutOut(onBlack: CanvasRenderingContext2D, onWhite: CanvasRenderingContext2D) {
  const { width, height } = onBlack.canvas;
  for (let top = 0; top < height; top += ROWS) {
    const rows = Math.min(ROWS, height - top);
    const picture = onBlack.getImageData(0, top, width, rows);
    const black = picture.data;
    const white = onWhite.getImageData(0, top, width, rows).data;
    for (let at = 0; at < black.length; at += 4) {
      const whiteSum = white[at] + white[at + 1] + white[at + 2];
      const blackSum = black[at] + black[at + 1] + black[at + 2];
      const covered = Math.min(Math.max(1 - (whiteSum - blackSum) / 765, 0), 1);
      for (let i = at; i < at + 3; i++) black[i] = covered > 0 ? black[i] / covered : 0;
      black[at + 3] = Math.round(255 * covered);
    }
    onBlack.putImageData(picture, 0, top);
  }
}
