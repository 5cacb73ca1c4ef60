/**
 * Worker that reads and writes Rhino files. It is separate because rhino3dm creates functions from
 * text, which the page's content security policy forbids, and so that a file that crashes it stops
 * nothing else.
 */

import { answerTo, type Call } from '../../solver/remote.ts';
import { meshFromRhino } from './rhino-in.ts';
import { rhinoFile, rhinoParts } from './rhino-out.ts';

const methods = {
  /** The mesh in a file, as OBJ. Hidden objects are in it if asked for. */
  read: meshFromRhino,
  /** A scene with the table of its face errors, as a file. */
  write: rhinoFile,
  /** The parts to be built, as a file. */
  writeParts: rhinoParts,
};
export type Rhino = typeof methods;

onmessage = async ({ data }: MessageEvent<Call>) =>
  postMessage(await answerTo(() => methods, data));
