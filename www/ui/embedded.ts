/** Whether the page is embedded: `?embed` in its address, which index.html reads first. */
export const isEmbedded = 'embed' in (globalThis.document?.documentElement.dataset ?? {});
