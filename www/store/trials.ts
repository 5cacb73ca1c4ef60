/**
 * What is tried in the second worker on a copy of the model, one trial at a time. A run, a drag or a
 * change of the model ends a trial; what was found belongs to the shape that was copied, and the
 * solver refuses it for another one.
 */

import { Cancelled } from '../solver/errors.ts';
import type { JobsClient } from '../solver/jobs-client.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { BetterPress, ExactFound, Remedy, Snapshot } from '../solver/types.ts';

/** Time limit of the search for better presses, in milliseconds. */
const MOST_PRESSES_MS = 20_000;
/** Time limit of the search for remedies, in milliseconds. */
const MOST_REMEDIES_MS = 4000;

export function createTrials(solver: SolverClient, { ask }: JobsClient) {
  /** Number of the current trial, and of changes that end every trial. */
  let [turn, changes] = [0, 0];
  /** Settled when the last trial has ended. */
  let last: Promise<unknown> = Promise.resolve();
  /** Generations of the problem and of the shape as last known. */
  let [problem, shape]: (number | undefined)[] = [];

  const end = () => {
    turn += 1;
    changes += 1;
  };
  solver.on('model', end);
  solver.on('scene', ({ generation }) => {
    if (generation !== problem) end();
    problem = generation;
  });
  // A run or a drag moves it.
  solver.on('frame', () => {
    if (solver.geometry?.generation !== shape) end();
    shape = solver.geometry?.generation;
  });

  /**
   * Tries until all is done.
   * @param goesOn whether to continue
   * @param after a slice, while it is the current trial
   * @returns whether it is still the current trial; null without a model
   */
  async function run(
    begin: (model: Snapshot) => Promise<unknown>,
    goesOn: () => boolean = () => true,
    after: () => Promise<unknown> = () => Promise.resolve(),
  ): Promise<boolean | null> {
    const model = solver.copy();
    if (!model) return null;
    turn += 1;
    const mine = turn;
    const trial = (async () => {
      await begin(model);
      let more = true;
      while (more && mine === turn && goesOn()) {
        more = await ask.advance();
        if (mine === turn) await after();
      }
      return mine === turn;
    })();
    last = trial.catch(() => null);
    return trial;
  }

  return {
    /** How far making panels of one shape will move the mesh, in words; null if none is offered. */
    async forecast() {
      // That of a model just opened has not come yet.
      if (!solver.copy()) await new Promise((come) => solver.once('scene', come));
      const model = solver.copy();
      // It may be cancelled with another job.
      const again = (error: unknown) => {
        if (error instanceof Cancelled && model) return ask.forecast(model);
        throw error;
      };
      return model && ask.forecast(model).catch(again);
    },

    /**
     * What meeting constraints exactly instead of within a distance would cost; null if something
     * changes meanwhile.
     * @param goesOn whether somebody waits for it
     */
    exactOffer: async (goesOn: () => boolean): Promise<ExactFound | null> =>
      (await run(ask.tryExact, goesOn)) ? ask.found() : null,

    /**
     * Searches for lower energy among equally exact shapes; returns how far it came, or null if
     * something changes meanwhile.
     * @param goesOn whether to search on
     */
    improvement: async (goesOn: () => boolean): Promise<ExactFound | null> =>
      (await run(ask.tryImprovement, goesOn)) ? ask.found() : null,

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
        const done = await run(ask.tryPresses, () => performance.now() < until, tell);
        if (done !== false || asked !== changes) return done;
      }
    },

    /** Changes that lower the worst distance; those found before something changes. */
    async remedies(): Promise<Remedy[]> {
      const until = performance.now() + MOST_REMEDIES_MS;
      const done = await run(ask.tryRemedies, () => performance.now() < until);
      return done === null ? [] : ask.remedies();
    },
  };
}
