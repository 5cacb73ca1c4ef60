/**
 * Returns the fragment that opens an example. Links are permanent; `share-link.js` reads them.
 * @param {string} id
 */
export const linkTo = (id) => `#example=${id}`;
