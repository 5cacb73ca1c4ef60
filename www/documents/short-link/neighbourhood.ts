/** Adjacency of faces and vertices, and an order of faces that favours prediction. */

/** Faces that lack this many unknown vertices or more share a queue. */
const MOST_MISSING = 6;

export class Neighbourhood {
  /** Incident faces of each vertex. */
  facesAt: number[][];
  /** Vertices that share an edge with each vertex. */
  beside: number[][];

  constructor(faces: number[][], vertices: number) {
    this.faces = faces;
    const each = Array.from({ length: vertices });
    this.facesAt = each.map(() => []);
    const beside = each.map(() => new Set());
    faces.forEach((face, index) =>
      face.forEach((vertex, at) => {
        const next = face[(at + 1) % face.length];
        if (this.facesAt[vertex].at(-1) !== index) this.facesAt[vertex].push(index);
        beside[vertex].add(next);
        beside[next].add(vertex);
      }),
    );
    this.beside = beside.map((others) => [...others]);
  }

  /** Whether two vertices have a common face. */
  share(a: number, b: number) {
    return this.facesAt[a].some((face) => this.facesAt[b].includes(face));
  }

  /** Returns the order of faces in which each next face has the fewest unknown vertices. */
  order() {
    const { faces, facesAt } = this;
    const missing = faces.map((face) => new Set(face).size);
    const isDone = new Uint8Array(faces.length);
    const isKnown = new Uint8Array(facesAt.length);
    /** Queues of faces by their number of unknown vertices when enqueued. */
    const queues: number[][] = Array.from({ length: MOST_MISSING + 1 }, () => []);
    const heads = queues.map(() => 0);
    const order: number[] = [];

    const next = () => {
      for (const [lack, queue] of queues.entries())
        while (heads[lack] < queue.length) {
          const face = queue[heads[lack]++];
          if (!isDone[face] && Math.min(missing[face], MOST_MISSING) === lack) return face;
        }
      return -1;
    };
    const take = (face: number) => {
      isDone[face] = 1;
      order.push(face);
      for (const vertex of faces[face]) {
        if (isKnown[vertex]) continue;
        isKnown[vertex] = 1;
        for (const other of facesAt[vertex]) {
          missing[other] -= 1;
          if (!isDone[other]) queues[Math.min(missing[other], MOST_MISSING)].push(other);
        }
      }
    };
    for (let seed = 0; seed < faces.length; seed++)
      for (let face = isDone[seed] ? -1 : seed; face >= 0; face = next()) take(face);
    return order;
  }
}
