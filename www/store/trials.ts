/**
 * What is tried in the second worker on a copy of the model, one trial at a time. A run, a drag or a
 * change of the model ends a trial; what was found belongs to the shape that was copied, and the
 * solver refuses it for another one.
 */

import { retryIfCollateral } from '../solver/errors.ts';
import type { JobsClient } from '../solver/jobs-client.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Remote } from '../solver/remote.ts';
import type {
  ModelCopy,
  BetterPress,
  ExactOffer,
  ExactShape,
  Suggestion,
} from '../pkg/engine/shape_up.js';

/** Time limit of the search for better presses, in milliseconds. */
const MOST_PRESSES_MS = 20_000;
/** Time limit of the search for suggestions, in milliseconds. */
const MOST_SUGGESTIONS_MS = 4000;

/** An exact shape with its cost. */
export interface ExactFound {
  offer: ExactOffer;
  shape: ExactShape;
  /** `#V by 3` */
  positions: Float64Array;
}

export function createTrials(solver: SolverClient, jobs: JobsClient) {
  const { ask, copy } = jobs.of('trials');
  /** Number of the current trial, and of changes that end every trial. */
  let [turn, changes] = [0, 0];
  /** Number of trials that have begun. */
  let begun = 0;
  /** Settled when the last trial has ended. */
  let last: Promise<unknown> = Promise.resolve();
  /** Generation of problem and shape as last known. */
  let known: number | undefined;

  const end = () => {
    turn += 1;
    changes += 1;
  };
  solver.on('model', end);
  const follow = ({ generation }: { generation: number }) => {
    if (generation !== known) end();
    known = generation;
  };
  // An edit changes the problem; a run or a drag moves the shape.
  solver.on('scene', follow);
  solver.on('frame', follow);

  /**
   * Tries until all is done.
   * @param goesOn whether to continue
   * @param after a slice, while it is the current trial
   * @param read what it has found, before a trial that waits begins; told whether it is still the
   * current trial
   * @returns what was read; undefined without a model
   */
  async function run<Found>(
    begin: (copy: Remote<ModelCopy>) => Promise<unknown>,
    goesOn: () => boolean,
    read: (isCurrent: boolean) => Promise<Found> | Found,
    after: () => Promise<unknown> = () => Promise.resolve(),
  ): Promise<Found | undefined> {
    const model = solver.copy();
    if (!model) return undefined;
    turn += 1;
    begun += 1;
    const [mine, own] = [turn, begun];
    const trial = retryIfCollateral(async () => {
      await begin(copy(model));
      let more = true;
      while (more && mine === turn && goesOn()) {
        more = await ask.advance();
        if (mine === turn) await after();
      }
      const found = await read(mine === turn);
      // Also after a change has ended it. Another trial has the copy in its turn.
      if (own === begun) void ask.free().catch(() => {});
      return found;
    });
    last = trial.catch(() => null);
    return trial;
  }

  /** The exact shape found so far; null if there is nothing to make exact, undefined after a change. */
  async function found(isCurrent: boolean): Promise<ExactFound | null | undefined> {
    if (!isCurrent) return undefined;
    const answers = [ask.offer(), ask.shape(), ask.positions()] as const;
    const [offer, shape, positions] = await Promise.all(answers);
    return offer && shape ? { offer, shape, positions } : null;
  }

  return {
    /** How far making panels of one shape will move the mesh, in words; null if none is offered. */
    async forecast() {
      // That of a model just opened has not come yet.
      if (!solver.copy()) await new Promise((come) => solver.once('scene', come));
      const model = solver.copy();
      if (!model) return null;
      return (await jobs.copy(model).forecast()) ?? null;
    },

    /**
     * What meeting constraints exactly instead of within a distance would cost; null if there is
     * nothing to make exact, undefined if something changes meanwhile.
     * @param goesOn whether somebody waits for it
     */
    exactOffer: (goesOn: () => boolean) => run((copy) => copy.tryExact(), goesOn, found),

    /**
     * Searches for lower energy among shapes that meet the same requirements; returns how far it came,
     * or undefined if something changes meanwhile.
     * @param goesOn whether to search on
     */
    improvement: (goesOn: () => boolean) => run((copy) => copy.tryImprovement(), goesOn, found),

    /**
     * Presses for panels that end better than the last one. Other trials go first.
     * @param found is called with those found so far, whenever there is another one
     */
    async betterPresses(found: (presses: BetterPress[]) => void) {
      const until = performance.now() + MOST_PRESSES_MS;
      let count = 0;
      const tell = async () => {
        const presses = await ask.betterPresses();
        if (presses.length !== count) found(presses);
        count = presses.length;
      };
      const asked = changes;
      for (;;) {
        const before = last;
        await before;
        if (asked !== changes) return false;
        if (last !== before) continue;
        const done = await run(
          (copy) => copy.tryPresses(),
          () => performance.now() < until,
          (isCurrent) => isCurrent,
          tell,
        );
        if (done !== false || asked !== changes) return done;
      }
    },

    /** Changes that lower the worst distance; those found before something changes. */
    async suggestions(): Promise<Suggestion[]> {
      const until = performance.now() + MOST_SUGGESTIONS_MS;
      const found = await run(
        (copy) => copy.trySuggestions(),
        () => performance.now() < until,
        () => ask.suggestions(),
      );
      return found ?? [];
    },
  };
}
