/** Of several questions and answers the latest one only. */

/**
 * Answers one question at a time and then the latest one, dropping those in between. A question is
 * answered even if an earlier answer fails.
 */
export function latestOnly<Question = void>(answer: (question: Question) => unknown) {
  /** The question to answer next. */
  let next: { question: Question } | null = null;
  let isBusy = false;

  /** Answers at once or, during an answer, after it. */
  async function ask(question: Question) {
    next = { question };
    if (isBusy) return;
    isBusy = true;
    try {
      while (next) {
        const now = next.question;
        next = null;
        await answer(now);
      }
    } finally {
      isBusy = false;
      if (next) await ask(next.question);
    }
  }

  return {
    ask,
    /** Whether a question is being answered. */
    isBusy: () => isBusy,
    /** Whether a later question waits, so that the current answer is out of date. */
    hasNext: () => next !== null,
  };
}

/**
 * Answers that are out of date, dropped in one place: those to a question after which another one was
 * asked, and those about something that has been replaced meanwhile, as another model.
 *
 * @param subjects what the answers are about, each compared by identity
 * @returns a function that passes an answer on; undefined if it is out of date, also if it failed
 */
export function newestOnly(...subjects: (() => unknown)[]) {
  let newest = 0;
  return async function <Answer>(answer: Promise<Answer> | Answer): Promise<Answer | undefined> {
    const mine = ++newest;
    const about = subjects.map((subject) => subject());
    const isOutdated = () =>
      mine !== newest || subjects.some((subject, i) => subject() !== about[i]);
    try {
      const value = await answer;
      return isOutdated() ? undefined : value;
    } catch (error) {
      if (isOutdated()) return undefined;
      throw error;
    }
  };
}

/** Features that compute much for each shape follow larger meshes only at rest. */
export const MOST_LIVE_VERTICES = 3000;
