export * from './shape_up.js';

/** Loads the module: in Node its file is read, in a browser it is fetched. Once is enough. */
export function load(): Promise<void>;
