/**
 * Calls of the methods of an object in a worker, by name. A wrong name, argument or use of an answer
 * is an error of the compiler, since the types are those of the methods themselves.
 */

import { isTrap, messageOf } from './errors.ts';

type Method = (...given: never[]) => unknown;
type Methods<Host> = {
  [
    Name in keyof Host as Name extends string ? (Host[Name] extends Method ? Name : never) : never
  ]: Host[Name];
};

/** What comes of a value that is sent: bytes have a buffer of their own. */
type Sent<Value> = Value extends Uint8Array ? Uint8Array<ArrayBuffer> : Value;

/** The methods of an object in a worker, which answer with promises. */
export type Remote<Host> = {
  [Name in keyof Methods<Host>]: Host[Name] extends (...given: infer Given) => infer Value
    ? (...given: Given) => Promise<Sent<Awaited<Value>>>
    : never;
};

/** The methods of an object in a worker, without answers. */
export type Told<Host> = {
  [Name in keyof Methods<Host>]: Host[Name] extends (...given: infer Given) => unknown
    ? (...given: Given) => void
    : never;
};

/** A call, as it is sent; one without `id` gets no answer. */
export interface Call {
  id?: number;
  name: string;
  given: unknown[];
  /** number of the mesh that the page shows, see `events.ts` */
  mesh?: number;
}

/** An answer, as it is sent back. After a trap, the engine in the worker is of no use. */
export type Answer =
  { id: number; value: unknown } | { id: number; refused: string; isDead: boolean };

/** Calls one of the methods of an object in a worker, which is returned by `host`. */
export async function answerTo(
  host: () => object | Promise<object>,
  { id = 0, name, given }: Call,
): Promise<Answer> {
  try {
    const methods = (await host()) as Record<string, (...given: unknown[]) => unknown>;
    return { id, value: await methods[name](...given) };
  } catch (thrown) {
    return { id, refused: messageOf(thrown), isDead: isTrap(thrown) };
  }
}

/** Returns an object whose methods are passed on to `call`. */
export function calling<Far extends object>(
  call: (name: string, given: unknown[]) => unknown,
): Far {
  return new Proxy({} as Far, {
    // It is no promise: `then` is no method of the far object.
    get: (_, name) =>
      typeof name === 'string' && name !== 'then'
        ? (...given: unknown[]) => call(name, given)
        : undefined,
  });
}

/** Calls that wait for their answers. */
export class Waiting {
  #calls: Map<
    number,
    { name: string; resolve: (value: unknown) => void; reject: (error: Error) => void }
  > = new Map();
  #nextId = 1;

  /** Number of calls without an answer. */
  get size() {
    return this.#calls.size;
  }

  /** Name of the first call without an answer; empty if there is none. */
  get first() {
    const [call] = this.#calls.values();
    return call?.name ?? '';
  }

  /** Sends a call, numbered, by `send`. */
  call(
    name: string,
    given: unknown[],
    send: (call: Call & { id: number }) => void,
  ): Promise<unknown> {
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      // It may be answered at once.
      this.#calls.set(id, { name, resolve, reject });
      try {
        send({ id, name, given });
      } catch (error) {
        this.#calls.delete(id);
        throw error;
      }
    });
  }

  /**
   * Settles a call: with its value, or with an error.
   * @returns the name of what was called
   */
  settle(id: number, value: unknown, error: Error | null): string | undefined {
    const waiting = this.#calls.get(id);
    this.#calls.delete(id);
    if (error) waiting?.reject(error);
    else waiting?.resolve(value);
    return waiting?.name;
  }

  /** Settles the call that is answered. */
  receive(answer: Answer) {
    if ('refused' in answer) this.settle(answer.id, null, new Error(answer.refused));
    else this.settle(answer.id, answer.value, null);
  }

  /**
   * Settles all calls with errors.
   * @param errorOf gets the name of each, its place in their order, and its number
   */
  fail(errorOf: (name: string, place: number, id: number) => Error) {
    [...this.#calls].forEach(([id, { name }], place) => {
      this.settle(id, null, errorOf(name, place, id));
    });
  }
}
