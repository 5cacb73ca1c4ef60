/** The methods of the worker for Rhino files: one file, so that whoever has read a file can write one. */

export { meshFromRhino as read } from './rhino-in.ts';
export { rhinoFile as write, rhinoParts as writeParts } from './rhino-out.ts';
