/** Whether the page is embedded: `?embed` in its address, which index.html reads first. */
export const isEmbedded = 'embed' in (globalThis.document?.documentElement.dataset ?? {});

/** Value of `embed` in the address of a view that was started by a press. */
export const PRESSED = 'pressed';
