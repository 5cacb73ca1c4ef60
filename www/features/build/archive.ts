/** Packs files into a ZIP archive, deflated by the browser. */

import { crc32 } from '../../documents/crc32.ts';
import { deflate } from '../../documents/deflate.ts';

/** A number and its size in bytes. */
type Field = [size: 2 | 4, value: number];

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
/** Header fields of every file: format version 2.0, UTF-8 names, deflate. */
const KIND: Field[] = [
  [2, 20],
  [2, 0x0800],
  [2, 8],
];

/** Encodes numbers one after another in little-endian order. */
function header(fields: Field[]) {
  const view = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(view.buffer);
}

/** Time (low two bytes) and date (high two bytes) in MS-DOS format. */
const stamp = (time: Date) =>
  (((time.getFullYear() - 1980) << 25) |
    ((time.getMonth() + 1) << 21) |
    (time.getDate() << 16) |
    (time.getHours() << 11) |
    (time.getMinutes() << 5) |
    (time.getSeconds() >> 1)) >>>
  0;

/** Returns the archive. */
export async function archive(files: [name: string, content: Uint8Array<ArrayBuffer>][]) {
  const time = stamp(new Date());
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const list: Uint8Array<ArrayBuffer>[] = [];
  const length = (all: Uint8Array[]) => all.reduce((sum, bytes) => sum + bytes.length, 0);
  for (const [name, content] of files) {
    const [called, packed] = [new TextEncoder().encode(name), await deflate(content)];
    const about: Field[] = [
      ...KIND,
      [4, time],
      [4, crc32(content)],
      [4, packed.length],
      [4, content.length],
      [2, called.length],
      [2, 0],
    ];
    /** Comment, disk and attributes (all zero), and the offset of the file. */
    const rest: Field[] = [
      [2, 0],
      [4, 0],
      [4, 0],
      [4, length(parts)],
    ];
    parts.push(header([[4, LOCAL], ...about]), called, packed);
    list.push(header([[4, CENTRAL], [2, 20], ...about, ...rest]), called);
  }
  const end = header([
    [4, END],
    [4, 0],
    [2, files.length],
    [2, files.length],
    [4, length(list)],
    [4, length(parts)],
    [2, 0],
  ]);
  return new Uint8Array(await new Blob([...parts, ...list, end]).arrayBuffer());
}
