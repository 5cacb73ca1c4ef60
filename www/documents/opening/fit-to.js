/** A second file as the reference surface of the open mesh, in place of its own rest shape. */

/**
 * Sets the reference surface, as one step of undo. An alert explains why a file is refused.
 * @param {File} file OBJ, OFF or Medit
 * @param {import("../../store/actions.js").Actions} actions
 */
export async function fitTo(file, actions) {
  const text = await file.text();
  await actions.edit({ type: 'fitTo', name: file.name, text });
}
