/** Whether the page is a quiet view in another page: `?embed` in its address, which index.html reads first. */
export const isEmbedded = 'embed' in (globalThis.document?.documentElement.dataset ?? {});
