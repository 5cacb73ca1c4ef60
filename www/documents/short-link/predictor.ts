/**
 * Predicts a vertex from known neighbours, by a parallelogram or a straight line, plus a learned
 * linear correction from the twist and the bend of the adjacent faces.
 */

import { alongPlane, planeAlong } from './plane-prediction.ts';
import { LeastSquares } from './least-squares.ts';
import { Neighbourhood } from './neighbourhood.ts';
import { dot, mean, minus, type Vector } from './vectors.ts';

/** Scales features to about 1 for a step of 1e-2 tolerances and a tolerance of 1e-3 edges. */
const UNIT = 1e5;

export class Predictor {
  #positions;
  #inPlanes;
  #last = [0, 0, 0] as Vector;
  /** Learned weights by configuration of known neighbours. */
  #learned: Map<string, LeastSquares> = new Map();

  /** @param inPlanes whether to predict by planes */
  constructor(faces: number[][], positions: Int32Array, inPlanes: boolean) {
    this.#positions = positions;
    this.#inPlanes = inPlanes;
    this.around = new Neighbourhood(faces, positions.length / 3);
    this.isKnown = new Uint8Array(positions.length / 3);
  }

  add(vertex: number) {
    this.isKnown[vertex] = 1;
    this.#last = this.#sum([1, vertex]);
  }

  /**
   * Returns the unknown vertex of a face with the most known neighbours in it; -1 if all are known.
   */
  next(face: number[]) {
    let best = -1;
    let most = -1;
    face.forEach((vertex, at) => {
      if (this.isKnown[vertex]) return;
      const beside = [face[(at + 1) % face.length], face[(at + face.length - 1) % face.length]];
      const known = beside.filter((other) => this.isKnown[other]).length;
      if (known > most) [best, most] = [vertex, known];
    });
    return best;
  }

  /** Predicts a vertex, in steps. */
  of(vertex: number) {
    const shapes = this.#parallelograms(vertex);
    const lines = this.#lines(vertex);
    const features: Vector[] = [];
    let sort = `${Math.min(shapes.length, 2)}`;
    let base = null;
    if (shapes.length > 0)
      base = mean(shapes.map(([a, b, across]) => this.#sum([1, a], [1, b], [-1, across])));
    if (lines.length > 0) {
      const straight = mean(lines.map(([near, far]) => this.#sum([2, near], [-1, far])));
      if (base) features.push(minus(straight, base));
      base ??= straight;
      const longer = lines.filter(([, , end]) => end >= 0);
      if (longer.length > 0)
        features.push(
          mean(longer.map(([near, far, end]) => this.#sum([1, near], [-2, far], [1, end]))),
        );
      sort += `,${Math.min(lines.length, 2)},${longer.length > 0}`;
    }
    if (shapes.length > 0) {
      const twists = this.#twists(vertex, shapes[0]);
      features.push(...twists);
      sort += `,${twists.length}`;
    }
    const kind = shapes.length > 0 ? 0 : lines.length > 0 ? 1 : 2;
    const beside = this.around.beside[vertex].filter((other) => this.isKnown[other]);
    base ??= beside.length > 0 ? mean(beside.map((other) => this.#sum([1, other]))) : this.#last;
    const plane =
      this.#inPlanes && shapes.length > 0
        ? this.#plane(vertex, shapes[0], base, features, sort)
        : null;
    const { at, learn } = this.#improved(vertex, base, features, sort);
    const learnAll = () => {
      learn();
      plane?.learn();
    };
    return { kind, at, plane, learn: learnAll };
  }

  /** Predicts the coordinate along the axis closest to the normal of a face from the other two. */
  #plane(
    vertex: number,
    [a, b, across]: [number, number, number],
    base: Vector,
    features: Vector[],
    sort: string,
  ) {
    const plane = planeAlong(this.#sum([1, a], [-1, across]), this.#sum([1, b], [-1, across]));
    if (!plane) return null;
    const { axis, slopes } = plane;
    const learned = this.#learnedOf(`plane,${sort}`, features.length);
    const off = features.map((feature) => dot(slopes, feature) / UNIT);
    const flat = () => alongPlane(plane, base, this.#sum([1, vertex]));
    return {
      axis,
      predicted: () => flat() + UNIT * learned.predict(off),
      learn: () => learned.learn(off, (this.#positions[3 * vertex + axis] - flat()) / UNIT),
    };
  }

  #learnedOf(sort: string, features: number) {
    const learned = this.#learned.get(sort) ?? new LeastSquares(features);
    this.#learned.set(sort, learned);
    return learned;
  }

  /** Applies the correction learned for the same configuration. */
  #improved(vertex: number, base: Vector, features: Vector[], sort: string) {
    if (features.length === 0) return { at: base, learn: () => {} };
    const learned = this.#learnedOf(sort, features.length);
    const along = base.map((_, axis) => features.map((feature) => feature[axis] / UNIT));
    return {
      at: base.map((value, axis) => value + UNIT * learned.predict(along[axis])),
      learn: () =>
        along.forEach((one, axis) =>
          learned.learn(one, (this.#positions[3 * vertex + axis] - base[axis]) / UNIT),
        ),
    };
  }

  /**
   * Returns a linear combination of positions.
   * @param terms factor and vertex
   */
  #sum(...terms: [number, number][]): Vector {
    const along = (axis: number) =>
      terms.reduce((sum, [factor, vertex]) => sum + factor * this.#positions[3 * vertex + axis], 0);
    return [along(0), along(1), along(2)];
  }

  /**
   * Returns for each face two known neighbours of the vertex and the known vertex opposite to it;
   * for triangles, the vertex across the opposite edge.
   */
  #parallelograms(vertex: number): [number, number, number][] {
    const { faces, facesAt } = this.around;
    const found: [number, number, number][] = [];
    for (const index of facesAt[vertex]) {
      const face = faces[index];
      const at = face.indexOf(vertex);
      const [a, across] = [face[(at + 1) % face.length], face[(at + 2) % face.length]];
      const b = face[(at + face.length - 1) % face.length];
      if (!this.isKnown[a] || !this.isKnown[b]) continue;
      const far = face.length > 3 ? across : this.#acrossSide(a, b, vertex);
      if (far >= 0 && this.isKnown[far]) found.push([a, b, far]);
    }
    return found;
  }

  /**
   * Returns a known vertex of the face on the other side of an edge; -1 if there is none.
   * @param vertex on this side of the edge
   */
  #acrossSide(a: number, b: number, vertex: number) {
    const { faces, facesAt } = this.around;
    const other = facesAt[a].find(
      (face) => facesAt[b].includes(face) && !faces[face].includes(vertex),
    );
    if (other === undefined) return -1;
    return faces[other].find((one) => one !== a && one !== b && this.isKnown[one]) ?? -1;
  }

  /**
   * Returns known vertices in line with a vertex: the next one, the second, and the third or -1.
   */
  #lines(vertex: number): [number, number, number][] {
    const found: [number, number, number][] = [];
    for (const near of this.around.beside[vertex]) {
      if (!this.isKnown[near]) continue;
      const far = this.#beyond(vertex, near);
      if (far >= 0) found.push([near, far, this.#beyond(near, far)]);
    }
    return found;
  }

  /** Returns the known neighbour of `near` that shares no face with `vertex`, or -1. */
  #beyond(vertex: number, near: number) {
    const isBeyond = (other: number) =>
      this.isKnown[other] === 1 && other !== vertex && !this.around.share(other, vertex);
    return this.around.beside[near].find(isBeyond) ?? -1;
  }

  /** Returns the deviation of known adjacent quads from parallelograms. */
  #twists(vertex: number, [a, b, across]: [number, number, number]) {
    const { faces, facesAt } = this.around;
    return [
      [a, b],
      [b, a],
    ].flatMap(([near, other]) => {
      const isTwisted = (index: number) => {
        const face = faces[index];
        return (
          face.length === 4 &&
          facesAt[across].includes(index) &&
          !face.includes(vertex) &&
          !face.includes(other) &&
          face.every((one) => this.isKnown[one])
        );
      };
      const found = facesAt[near].find(isTwisted);
      if (found === undefined) return [];
      const face = faces[found];
      const from = face.indexOf(across);
      const corner = (k: number) => face[(from + k) % 4];
      return [this.#sum([1, across], [-1, corner(1)], [1, corner(2)], [-1, corner(3)])];
    });
  }
}
