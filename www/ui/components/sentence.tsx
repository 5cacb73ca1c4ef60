/** Sentences with lengths. */

/** A length, which is never broken between its number and its unit. */
const LENGTH = /(?<![\d.])([\d.]+ (?:mm|cm|m|ft|in)\b)/;

/**
 * A sentence in which no line ends between a number and its unit. It is one element, since a button
 * lays out each piece of text in it as a column.
 */
export function Sentence({ words }: { words: string }) {
  return (
    <span>
      {/* Every other part is a length. A no-break space would be another text. */}
      {words.split(LENGTH).map((part, k) =>
        k % 2 ? (
          <span key={k} class="unbroken">
            {part}
          </span>
        ) : (
          part
        ),
      )}
    </span>
  );
}
