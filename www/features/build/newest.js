/**
 * Answers one question at a time and then the newest one, dropping those in between.
 * @template Question
 * @param {(question: Question) => Promise<unknown>} answer
 */
export function newest(answer) {
  /** @type {Question[]} */
  let waiting = [];
  let isBusy = false;
  return {
    /** @param {Question} question */
    async ask(question) {
      waiting = [question];
      if (isBusy) return;
      isBusy = true;
      for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) await answer(next);
      isBusy = false;
    },
  };
}
