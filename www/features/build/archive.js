/** Files packed into one, as ZIP: the browser deflates them. */

/** A number in so many bytes. @typedef {[size: 2 | 4, value: number]} Field */

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
/** What unpacks it knows version 2.0 of the format; names are UTF-8; files are deflated. @type {Field[]} */
const KIND = [
  [2, 20],
  [2, 0x0800],
  [2, 8],
];

/** For each byte the remainder that it leaves. */
const REMAINDERS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let left = byte;
  for (let bit = 0; bit < 8; bit++) left = left & 1 ? 0xedb88320 ^ (left >>> 1) : left >>> 1;
  return left;
});

/** The CRC-32. @param {Uint8Array} bytes */
function checksum(bytes) {
  let left = -1;
  for (const byte of bytes) left = REMAINDERS[(left ^ byte) & 255] ^ (left >>> 8);
  return ~left >>> 0;
}

/** Numbers one after another, the lowest byte first. @param {Field[]} fields */
function header(fields) {
  const view = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(view.buffer);
}

/** The bytes as the format packs them. @param {Uint8Array<ArrayBuffer>} bytes */
async function deflated(bytes) {
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}

/** The time of day in two bytes, then the day, as the format has them. @param {Date} time */
const stamp = (time) =>
  (((time.getFullYear() - 1980) << 25) |
    ((time.getMonth() + 1) << 21) |
    (time.getDate() << 16) |
    (time.getHours() << 11) |
    (time.getMinutes() << 5) |
    (time.getSeconds() >> 1)) >>>
  0;

/** The archive of some files. @param {[name: string, content: Uint8Array<ArrayBuffer>][]} files */
export async function archive(files) {
  const time = stamp(new Date());
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const list = [];
  const length = (/** @type {Uint8Array[]} */ all) =>
    all.reduce((sum, bytes) => sum + bytes.length, 0);
  for (const [name, content] of files) {
    const [called, packed] = [new TextEncoder().encode(name), await deflated(content)];
    /** @type {Field[]} */
    const about = [
      ...KIND,
      [4, time],
      [4, checksum(content)],
      [4, packed.length],
      [4, content.length],
      [2, called.length],
      [2, 0],
    ];
    /** Nothing is said of comments, disks and attributes. @type {Field[]} */
    const rest = [
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
