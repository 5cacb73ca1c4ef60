/**
 * Coding of faces in a link; their order and first corners are kept. A corner is coded as its rank
 * in a list of likely vertices, predicted from the corners and faces before it, or else as the
 * difference to the same corner of the previous face.
 */

import type { RangeCoder } from './range-coder.ts';

/** Bits of a rank in the list of likely vertices; rank 0 means "not in the list". */
const RANK_BITS = 4;
const RANKS = 1 << RANK_BITS;
/** Further corners share their contexts. */
const CORNERS = 7;

/** Context keys, one range per quantity. */
const KEY = { size: 0, apart: 1, rank: 16 };

/** State of the prediction, updated after each face. */
class FaceHistory {
  #vertices;
  #isSeen;
  /** The lowest vertex that is in no face yet. */
  #low = 0;
  #high = -1;
  /** Predecessors of each vertex in its faces. */
  #before: Map<number, number[]> = new Map();
  /** Directed edges of the faces. */
  #sides: Set<number> = new Set();
  face: number[] = [];
  /** Differences of the last face's corners to those of the face before it. */
  #steps: number[] = [];

  constructor(vertices: number) {
    this.#vertices = vertices;
    this.#isSeen = new Uint8Array(vertices + 1);
  }

  /**
   * Returns the vertices likely to be the next corner, likeliest first.
   * @param corners of the current face, so far
   */
  likely(corners: number[]) {
    const found = new Set();
    const at = corners.length;
    // The last face's step, repeated.
    if (this.#steps[at] !== undefined) found.add(this.face[at] + this.#steps[at]);
    if (at > 0) {
      // Across an edge that has a face on one side only.
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
      .slice(0, RANKS - 1);
  }

  add(face: number[]) {
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
 * Writes or reads faces.
 * @param faces the faces to write; empty in a reader
 */
export function codeFaces(
  coder: RangeCoder,
  vertices: number,
  count: number,
  faces: number[][],
): number[][] {
  const history = new FaceHistory(vertices);
  /** Ranks of the corners of the last face. */
  const ranks: number[] = [];
  const coded = [];
  let size = 4;
  for (let i = 0; i < count; i++) {
    const given = faces[i] ?? [];
    size += coder.integer(KEY.size, given.length - size);
    if (size < 3 || size > vertices) throw new RangeError('a face of no size');
    const face: number[] = [];
    for (let at = 0; at < size; at++) {
      const likely = history.likely(face);
      const [before, above] = [ranks[at] ?? 0, ranks[at - 1] ?? 0];
      const key = (before * RANKS + above) * (CORNERS + 1) + Math.min(at, CORNERS);
      const rank = coder.symbol(KEY.rank + key, RANK_BITS, likely.indexOf(given[at]) + 1);
      const base = history.face[at] ?? 0;
      const vertex =
        rank > 0
          ? likely[rank - 1]
          : base + coder.integer(KEY.apart + Math.min(at, CORNERS), given[at] - base);
      if (!(vertex >= 0 && vertex < vertices)) throw new RangeError('no such vertex');
      ranks[at] = rank;
      face.push(vertex);
    }
    history.add(face);
    coded.push(face);
  }
  return coded;
}
