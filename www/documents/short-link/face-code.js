/**
 * Faces in a link, in their order and each from its first corner: every corner is told by its place among
 * the vertices that are likely there, which those before it say, or by its difference to the corner
 * of the face before.
 */

/** @typedef {import("./range-coder.js").RangeCoder} RangeCoder */

/** Places among the likely vertices, the first of which is for all others. */
const PLACE_BITS = 4;
const PLACES = 1 << PLACE_BITS;
/** Corners beyond share their contexts. */
const CORNERS = 7;

/** Keys of contexts, one range for each quantity. */
const KEY = { size: 0, apart: 1, place: 16 };

/** What is known while faces go by. */
class Seen {
  #vertices;
  #isSeen;
  /** The lowest vertex that no face has had. */
  #low = 0;
  #high = -1;
  /** Vertices before each vertex in its faces. @type {Map<number, number[]>} */
  #before = new Map();
  /** Sides of faces in their direction. @type {Set<number>} */
  #sides = new Set();
  /** @type {number[]} */
  face = [];
  /** From the face before the last one to it, by corner. @type {number[]} */
  #steps = [];

  /** @param {number} vertices */
  constructor(vertices) {
    this.#vertices = vertices;
    this.#isSeen = new Uint8Array(vertices + 1);
  }

  /**
   * Vertices that are likely to be the next corner, the likeliest first.
   * @param {number[]} corners of the face before it
   */
  likely(corners) {
    const found = new Set();
    const at = corners.length;
    // As the last face did.
    if (this.#steps[at] !== undefined) found.add(this.face[at] + this.#steps[at]);
    if (at > 0) {
      // Across a side of a face that has no face there yet.
      const from = corners[at - 1];
      const others = this.#before.get(from) ?? [];
      for (let i = others.length - 1; i >= 0; i--)
        if (!this.#sides.has(from * this.#vertices + others[i])) found.add(others[i]);
    }
    while (this.#isSeen[this.#low]) this.#low += 1;
    for (const next of [this.#high + 1, this.#low, this.#high + 2, ...this.face]) found.add(next);
    for (const corner of corners) found.delete(corner);
    return [...found]
      .filter((vertex) => vertex >= 0 && vertex < this.#vertices)
      .slice(0, PLACES - 1);
  }

  /** @param {number[]} face */
  add(face) {
    face.forEach((vertex, at) => {
      const next = face[(at + 1) % face.length];
      this.#sides.add(vertex * this.#vertices + next);
      const before = this.#before.get(next);
      if (before) before.push(vertex);
      else this.#before.set(next, [vertex]);
      this.#isSeen[vertex] = 1;
      this.#high = Math.max(this.#high, vertex);
    });
    this.#steps = face.map((vertex, at) => vertex - (this.face[at] ?? 0));
    this.face = face;
  }
}

/**
 * Writes faces, or reads them.
 * @param {RangeCoder} coder
 * @param {number} vertices
 * @param {number} count
 * @param {number[][]} faces what is written; nothing in a reader
 * @returns {number[][]}
 */
export function codeFaces(coder, vertices, count, faces) {
  const seen = new Seen(vertices);
  /** Where the corners of the last face were. @type {number[]} */
  const places = [];
  const coded = [];
  let size = 4;
  for (let i = 0; i < count; i++) {
    const given = faces[i] ?? [];
    size += coder.integer(KEY.size, given.length - size);
    if (size < 3 || size > vertices) throw new RangeError('a face of no size');
    /** @type {number[]} */
    const face = [];
    for (let at = 0; at < size; at++) {
      const likely = seen.likely(face);
      const [before, above] = [places[at] ?? 0, places[at - 1] ?? 0];
      const key = (before * PLACES + above) * (CORNERS + 1) + Math.min(at, CORNERS);
      const place = coder.symbol(KEY.place + key, PLACE_BITS, likely.indexOf(given[at]) + 1);
      const base = seen.face[at] ?? 0;
      const vertex =
        place > 0
          ? likely[place - 1]
          : base + coder.integer(KEY.apart + Math.min(at, CORNERS), given[at] - base);
      if (!(vertex >= 0 && vertex < vertices)) throw new RangeError('no such vertex');
      places[at] = place;
      face.push(vertex);
    }
    seen.add(face);
    coded.push(face);
  }
  return coded;
}
