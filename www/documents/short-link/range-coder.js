/**
 * An adaptive binary range coder: each bit is written in about as many bits as its context makes it
 * surprising. Writer and reader have one interface, so that what is coded is described once: each method
 * takes the value to write and returns the value, and a reader ignores what it is given.
 *
 * Only integers, and sums, products and quotients of them that every engine rounds alike, so that every
 * browser reads what another one wrote. Carries as in LZMA (Martin 1979; Pavlov).
 */

const TOP = 2 ** 24;
const ONE = 2 ** 16;
const HALF = ONE / 2;
/** No bit is so certain that the opposite costs more than eight bits. */
const [LEAST, MOST] = [300, ONE - 300];
/** A context follows what it has seen; after so many bits, the newest of them. */
const MEMORY = 60;
/** Bits of a length: magnitudes are below 2^31. */
const LENGTH_BITS = 5;
/** So many of the bits after the first have contexts; the others are as good as random. */
const MODELLED = 2;
/** Contexts of one key: those of a tree of 16 symbols, of a length, and of the bits after it. */
const SPAN = 256;

/** @typedef {{ zero: number, seen: number }} Context of 65536, the probability of a 0 */

class Coder {
  /** @type {Map<number, Context>} */
  #contexts = new Map();
  #range = 2 ** 32 - 1;

  /**
   * The bit: the range before the bound is that of a 0, the range from there on that of a 1.
   * @param {number} _bound
   * @param {number} bit
   * @returns {number}
   */
  choose(_bound, bit) {
    return bit;
  }

  /** The range was made larger by a byte. */
  shift() {}

  /**
   * @param {number} zero of 65536, the probability of a 0
   * @param {number} bit
   */
  code(zero, bit) {
    const bound = (this.#range >>> 16) * zero;
    const coded = this.choose(bound, bit);
    this.#range = coded ? this.#range - bound : bound;
    while (this.#range < TOP) {
      this.#range *= 256;
      this.shift();
    }
    return coded;
  }

  /**
   * @param {number} key of the context
   * @param {number} bit
   */
  #bit(key, bit) {
    let context = this.#contexts.get(key);
    if (!context) this.#contexts.set(key, (context = { zero: HALF, seen: 0 }));
    const coded = this.code(context.zero, bit);
    const rate = Math.min(context.seen, MEMORY) + 1.6;
    const next = Math.round(context.zero + ((coded ? 0 : ONE) - context.zero) / rate);
    context.zero = Math.min(Math.max(next, LEAST), MOST);
    context.seen += 1;
    return coded;
  }

  /**
   * The low bits of a number, the highest first.
   * @param {number} key of their contexts
   * @param {number} bits at most 5
   * @param {number} value
   */
  symbol(key, bits, value) {
    let node = 1;
    for (let i = bits - 1; i >= 0; i--)
      node = 2 * node + this.#bit(SPAN * key + node, (value >> i) & 1);
    return node - (1 << bits);
  }

  /**
   * An integer of any sign, below 2^31 in size.
   * @param {number} key of its contexts
   * @param {number} value
   */
  integer(key, value) {
    const size = Math.abs(value);
    const length = this.symbol(key, LENGTH_BITS, 32 - Math.clz32(size));
    if (length === 0) return 0;
    let read = 1;
    for (let i = length - 2; i >= 0; i--) {
      const bit = (size >> i) & 1;
      const isModelled = i >= length - 1 - MODELLED;
      const context = SPAN * key + 32 + 4 * length + (i === length - 2 ? 0 : 1 + (read & 1));
      read = 2 * read + (isModelled ? this.#bit(context, bit) : this.code(HALF, bit));
    }
    return this.code(HALF, value < 0 ? 1 : 0) ? -read : read;
  }
}

export class RangeWriter extends Coder {
  /** @type {number[]} */
  #bytes = [];
  #low = 0;
  #held = 0;
  /** Bytes of 255 after the held one, which a carry would turn over. */
  #pending = -1;

  /** @override @param {number} bound @param {number} bit */
  choose(bound, bit) {
    if (bit) this.#low += bound;
    return bit;
  }

  /** @override */
  shift() {
    if (this.#low < 255 * TOP || this.#low >= 2 ** 32) {
      const carry = this.#low >= 2 ** 32 ? 1 : 0;
      // The first of all would be a 0 that says nothing.
      if (this.#pending >= 0) {
        this.#bytes.push(this.#held + carry);
        for (; this.#pending > 0; this.#pending--) this.#bytes.push((255 + carry) & 255);
      }
      this.#pending = 0;
      this.#held = Math.floor(this.#low / TOP) & 255;
    } else this.#pending += 1;
    this.#low = (this.#low % TOP) * 256;
  }

  /** All that was written; zeros at the end are read from nothing. */
  bytes() {
    for (let i = 0; i < 5; i++) this.shift();
    while (this.#bytes.at(-1) === 0) this.#bytes.pop();
    return Uint8Array.from(this.#bytes);
  }
}

export class RangeReader extends Coder {
  #bytes;
  #at = 0;
  #code = 0;

  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    super();
    this.#bytes = bytes;
    for (let i = 0; i < 4; i++) this.shift();
  }

  /** @override @param {number} bound */
  choose(bound) {
    if (this.#code < bound) return 0;
    this.#code -= bound;
    return 1;
  }

  /** @override */
  shift() {
    this.#code = this.#code * 256 + (this.#bytes[this.#at] ?? 0);
    this.#at += 1;
  }
}

/** @typedef {RangeWriter | RangeReader} RangeCoder */
