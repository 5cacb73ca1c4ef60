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
