/**
 * The picture of the first example that the build put into the page: it is there before anything
 * can draw, and goes when the view has drawn, or when something else is opened.
 */
export function removeFirstPicture() {
  document.getElementById('first-picture')?.remove();
}
