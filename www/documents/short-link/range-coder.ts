/**
 * Adaptive binary range coder: a bit costs about as many bits as it is surprising in its context.
 * Writer and reader share an interface, so that each format is described once: a method takes the
 * value to write and returns the value; a reader ignores its argument.
 *
 * Uses integers, and sums, products and quotients that every engine rounds alike, so that every
 * browser reads what another one wrote. Carries as in LZMA (Martin 1979; Pavlov).
 */

const TOP = 2 ** 24;
const ONE = 2 ** 16;
const HALF = ONE / 2;
/** Bounds of a probability: no bit costs more than eight bits. */
const [LEAST, MOST] = [300, ONE - 300];
/** Window of adaptation: a context averages over about this many recent bits. */
const MEMORY = 60;
/** Bits of a bit length: magnitudes are below 2^31. */
const LENGTH_BITS = 5;
/** Number of bits after the leading one that have contexts; the others are practically random. */
const MODELLED = 2;
/** Contexts per key: a tree of 16 symbols, a bit length, and the bits after the leading one. */
const SPAN = 256;

/** `zero`: probability of a 0, in units of 1/65536 */
type Context = { zero: number; seen: number };

class Coder {
  #contexts: Map<number, Context> = new Map();
  #range = 2 ** 32 - 1;

  /** Chooses the bit: a 0 takes the range below the bound, a 1 the range from there on. */
  choose(_bound: number, bit: number): number {
    return bit;
  }

  /** Called after the range was extended by a byte. */
  shift() {}

  /** @param zero probability of a 0, in units of 1/65536 */
  code(zero: number, bit: number) {
    const bound = (this.#range >>> 16) * zero;
    const coded = this.choose(bound, bit);
    this.#range = coded ? this.#range - bound : bound;
    while (this.#range < TOP) {
      this.#range *= 256;
      this.shift();
    }
    return coded;
  }

  /** @param key of the context */
  #bit(key: number, bit: number) {
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
   * Codes the low bits of a number, highest first.
   * @param key of their contexts
   * @param bits at most 5
   */
  symbol(key: number, bits: number, value: number) {
    let node = 1;
    for (let i = bits - 1; i >= 0; i--)
      node = 2 * node + this.#bit(SPAN * key + node, (value >> i) & 1);
    return node - (1 << bits);
  }

  /**
   * Codes a signed integer of magnitude below 2^31.
   * @param key of its contexts
   */
  integer(key: number, value: number) {
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
  #bytes: number[] = [];
  #low = 0;
  #held = 0;
  /** Number of 255s after the held byte, which a carry would turn to 0; -1 before the first. */
  #pending = -1;

  choose(bound: number, bit: number) {
    if (bit) this.#low += bound;
    return bit;
  }

  shift() {
    if (this.#low < 255 * TOP || this.#low >= 2 ** 32) {
      const carry = this.#low >= 2 ** 32 ? 1 : 0;
      // The very first byte is always 0 and is omitted.
      if (this.#pending >= 0) {
        this.#bytes.push(this.#held + carry);
        for (; this.#pending > 0; this.#pending--) this.#bytes.push((255 + carry) & 255);
      }
      this.#pending = 0;
      this.#held = Math.floor(this.#low / TOP) & 255;
    } else this.#pending += 1;
    this.#low = (this.#low % TOP) * 256;
  }

  /** Returns the code without trailing zeros, which a reader supplies. */
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

  constructor(bytes: Uint8Array) {
    super();
    this.#bytes = bytes;
    for (let i = 0; i < 4; i++) this.shift();
  }

  choose(bound: number) {
    if (this.#code < bound) return 0;
    this.#code -= bound;
    return 1;
  }

  shift() {
    this.#code = this.#code * 256 + (this.#bytes[this.#at] ?? 0);
    this.#at += 1;
  }
}

export type RangeCoder = RangeWriter | RangeReader;
