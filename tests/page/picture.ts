// Screenshots as pixels. Decodes the PNG files of Chromium: 8-bit RGB or RGBA, not interlaced.

import { inflateSync } from 'node:zlib';

/** Predicts a byte from its left, upper and upper left neighbours (PNG filter type 4). */
function paeth(left: number, up: number, corner: number) {
  const estimate = left + up - corner;
  const [a, b, c] = [left, up, corner].map((value) => Math.abs(estimate - value));
  if (a <= b && a <= c) return left;
  return b <= c ? up : corner;
}

/** A picture of `height * width * channels` bytes. */
export interface Picture {
  width: number;
  height: number;
  channels: number;
  pixels: Buffer;
}

/** Decodes a PNG. */
export function decodePng(bytes: Buffer): Picture {
  let [width, height, channels] = [0, 0, 0];
  const parts = [];
  for (let at = 8; at < bytes.length;) {
    const length = bytes.readUInt32BE(at);
    const type = bytes.toString('latin1', at + 4, at + 8);
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') {
      [width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
      channels =
        new Map([
          [2, 3],
          [6, 4],
        ]).get(data[9]) ?? 0;
      if (data[8] !== 8 || !channels || data[12] !== 0) {
        throw new Error(`PNG of depth ${data[8]}, colour type ${data[9]}, interlace ${data[12]}`);
      }
    }
    if (type === 'IDAT') parts.push(data);
    at += length + 12;
  }

  const packed = inflateSync(Buffer.concat(parts));
  const stride = width * channels;
  const pixels = Buffer.alloc(height * stride);
  for (let y = 0; y < height; y++) {
    const filter = packed[y * (stride + 1)];
    for (let x = 0; x < stride; x++) {
      const here = y * stride + x;
      const left = x >= channels ? pixels[here - channels] : 0;
      const up = y > 0 ? pixels[here - stride] : 0;
      const corner = x >= channels && y > 0 ? pixels[here - stride - channels] : 0;
      const predicted = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      pixels[here] = packed[y * (stride + 1) + 1 + x] + predicted;
    }
  }
  return { width, height, channels, pixels };
}

/** The colour of a pixel, [red, green, blue]. */
export function colourAt(picture: Picture, x: number, y: number) {
  const at = (Math.round(y) * picture.width + Math.round(x)) * picture.channels;
  return [...picture.pixels.subarray(at, at + 3)];
}

/** The number of bytes that differ between two pictures of the same size. */
export const differingBytes = (a: Picture, b: Picture) =>
  a.pixels.reduce((sum, byte, at) => sum + Number(byte !== b.pixels[at]), 0);

/** The number of different colours in a region, by default the whole picture. */
export function distinctColours(picture: Picture, region: Partial<DOMRectInit> = {}) {
  const { x = 0, y = 0, width = picture.width - x, height = picture.height - y } = region;
  const colours = new Set();
  for (let row = y; row < y + height; row++) {
    for (let column = x; column < x + width; column++) {
      const at = (row * picture.width + column) * picture.channels;
      colours.add(picture.pixels.readUIntBE(at, 3));
    }
  }
  return colours.size;
}
