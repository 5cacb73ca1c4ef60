/**
 * The picture of the first example in `index.html`, which covers the view until it has drawn or
 * another model is opened.
 */

const find = () => document.getElementById('first-picture');

export const isFirstPictureShown = () => find() !== null;

export function removeFirstPicture() {
  find()?.remove();
}
