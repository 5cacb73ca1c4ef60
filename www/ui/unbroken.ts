/** Lengths in sentences. */

/** Returns a sentence in which no line ends between a number and its unit. */
export function unbroken(words: string) {
  return words.replaceAll(/(?<=\d) (?=(mm|cm|m|ft|in)\b)/g, '\u00a0');
}
