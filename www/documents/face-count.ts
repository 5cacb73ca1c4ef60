/**
 * The number of faces of a mesh file while it is read: what is too large is asked about before it is
 * opened. Not of Rhino files, whose meshes are known after their conversion.
 */

const [LF, CR, SPACE, TAB, F] = [10, 13, 32, 9, 102];
/** In so many bytes a header ends. */
const HEAD = 65536;

export interface FaceCount {
  /** those known so far */
  faces: number;
  take: (chunk: Uint8Array) => void;
}

/** Counts the lines of an OBJ file that begin with "f ". */
class ObjFaces implements FaceCount {
  faces = 0;
  /** The last two bytes before the chunk. */
  #before = [LF, LF];

  take(chunk: Uint8Array) {
    let [last, previous] = this.#before;
    for (const byte of chunk) {
      const isGap = byte === SPACE || byte === TAB;
      if (isGap && previous === F && (last === LF || last === CR)) this.faces += 1;
      last = previous;
      previous = byte;
    }
    this.#before = [last, previous];
  }
}

/** Reads the number in the header of a file. */
class HeaderFaces implements FaceCount {
  faces = 0;
  #head = '';
  #read;

  /** @param read finds it in the beginning of the file; 0 if it is not there yet */
  constructor(read: (head: string) => number) {
    this.#read = read;
  }

  take(chunk: Uint8Array) {
    if (this.faces > 0 || this.#head.length >= HEAD) return;
    this.#head += textOf(chunk.subarray(0, HEAD));
    this.faces = this.#read(this.#head);
  }
}

/** Adds up the numbers after the words "Triangles" and "Quadrilaterals" of a Medit file. */
class MeditFaces implements FaceCount {
  faces = 0;
  /** What may be the beginning of such a section. */
  #rest = '';

  take(chunk: Uint8Array) {
    const text = this.#rest + textOf(chunk);
    let end = 0;
    for (const found of text.matchAll(/\b(?:Triangles|Quadrilaterals)\s+(\d+)\s/g)) {
      this.faces += Number(found[1]);
      end = found.index + found[0].length;
    }
    this.#rest = text.slice(Math.max(end, text.length - 64));
  }
}

/** Counts the facets of an STL file: a number in a binary one, seven lines each in another. */
class StlFaces implements FaceCount {
  faces = 0;
  #binary: HeaderFaces;
  #lines = 0;

  constructor(size: number) {
    this.#binary = new HeaderFaces((head) => {
      const count = [83, 82, 81, 80].reduce((sum, at) => 256 * sum + head.charCodeAt(at), 0);
      return size === 84 + 50 * count ? count : 0;
    });
  }

  take(chunk: Uint8Array) {
    this.#binary.take(chunk);
    for (const byte of chunk) if (byte === LF) this.#lines += 1;
    this.faces = this.#binary.faces || Math.floor(this.#lines / 7);
  }
}

const numberIn = (text: string, pattern: RegExp) => Number(pattern.exec(text)?.[1] ?? 0);

const COUNTS: Record<string, (size: number) => FaceCount> = {
  obj: () => new ObjFaces(),
  mesh: () => new MeditFaces(),
  stl: (size) => new StlFaces(size),
  ply: () => new HeaderFaces((head) => numberIn(head, /^element\s+face\s+(\d+)\s/m)),
  off: () =>
    new HeaderFaces((head) =>
      numberIn(head.replaceAll(/#.*/g, ''), /^\s*(?:\w*OFF\b)?\s*\d+\s+(\d+)\s/),
    ),
};

/** Returns the count for a file; null for one whose faces are not known while it is read. */
export function faceCountOf({ name, size }: Pick<File, 'name' | 'size'>): FaceCount | null {
  const ending = name.split('.').pop()?.toLowerCase() ?? '';
  return COUNTS[ending]?.(size) ?? null;
}

/** One character for each byte. */
const textOf = (bytes: Uint8Array) => new TextDecoder('latin1').decode(bytes);
