/** Returns the permanent fragment of an example, see `share-link.js`. @param {string} id */
export const linkTo = (id) => `#example=${id}`;
