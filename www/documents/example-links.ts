/** Returns the permanent fragment of an example, see `share-link.ts`. */
export const linkTo = (id: string) => `#example=${id}`;
