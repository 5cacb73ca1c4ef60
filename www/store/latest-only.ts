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

/** Features that compute much for each shape follow larger meshes only at rest. */
export const MOST_LIVE_VERTICES = 3000;
