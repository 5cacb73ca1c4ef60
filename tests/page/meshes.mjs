// Meshes for the page tests, small enough to be solved in a blink.

/** A wavy grid of n by n quads, one unit each: the text of an OBJ file. */
export function wavyGrid(n) {
  const lines = [];
  for (let y = 0; y <= n; y++) {
    for (let x = 0; x <= n; x++) {
      const z = 0.4 * Math.sin(1.3 * x + 0.4 * y) + 0.3 * Math.cos(0.9 * y);
      lines.push(`v ${x} ${y} ${z.toFixed(6)}`);
    }
  }
  for (let y = 0; y < n; y++) {
    for (let x = 0; x < n; x++) {
      const corner = y * (n + 1) + x + 1;
      lines.push(`f ${corner} ${corner + 1} ${corner + n + 2} ${corner + n + 1}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** A file for a file input. */
export const file = (name, text) => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(text),
});
