/** A second file whose surface the open mesh is kept close to, instead of to its own. */

/**
 * One step of undo; the alert says why where the file is refused.
 * @param {File} file OBJ, OFF or Medit
 * @param {import("../../store/actions.js").Actions} actions
 */
export async function fitTo(file, actions) {
  const text = await file.text();
  await actions.edit({ type: 'fitTo', name: file.name, text });
}
