/**
 * Answers one question at a time and then the latest one, dropping those in between. A question is
 * answered even if an earlier answer fails.
 * @template [Question=void]
 * @param {(question: Question) => unknown} answer
 */
export function latestOnly(answer) {
  /** The question to answer next. @type {{ question: Question } | null} */
  let next = null;
  let isBusy = false;

  /** Answers at once or, during an answer, after it. @param {Question} question */
  async function ask(question) {
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
