/**
 * What is typed into a number field and is not part of a number. Browsers leave such characters out
 * without a word, so that `2*0.5` became 20.5: here they are refused with words, with all that
 * follows, until the field is edited otherwise or left.
 */

/** What numbers are written with; each field refuses what is no number by itself. */
const PART = /^[\d.,eE+−-]*$/;

/** Refuses it in all number fields of the page. */
export function refuseExpressions() {
  /** The field in which a character was refused. */
  let refused: HTMLInputElement | null = null;
  const accept = () => {
    refused?.setCustomValidity('');
    refused = null;
  };

  document.addEventListener('beforeinput', (event) => {
    const field = event.target;
    if (!(field instanceof HTMLInputElement) || field.type !== 'number') return;
    const text = event.data?.trim();
    if (!text) return event.inputType.startsWith('delete') ? accept() : undefined;
    if (field !== refused && PART.test(text)) return;
    event.preventDefault();
    if (field === refused) return;
    accept();
    refused = field;
    field.setCustomValidity(`“${text}” is not part of a number. Write the result, such as 0.5.`);
    field.reportValidity();
  });
  document.addEventListener('keydown', ({ key, ctrlKey, metaKey }) => {
    // Enter and Tab report the field as it is, which is not what was meant.
    const reports = key === 'Enter' || key === 'Tab';
    if ((key.length > 1 && !reports) || ctrlKey || metaKey) accept();
  });
  // After the field itself has been told, and found it invalid.
  document.addEventListener('change', accept);
  document.addEventListener('focusout', accept);
}
