/**
 * Commits what is being typed, as leaving its field does: browsers tell of a change only then, and a
 * key that saves or undoes acts on what the user sees. The field keeps the focus.
 */
export function commitTyping() {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement || field instanceof HTMLTextAreaElement)) return;
  field.blur();
  if (field.isConnected) field.focus({ preventScroll: true });
}
