/**
 * Worker that reads and writes Rhino files. It is separate because rhino3dm creates functions from
 * text, which the page's content security policy forbids, and so that a file that crashes it stops
 * nothing else.
 */

import { answerTo, type Call } from '../../solver/remote.ts';

// What they import waits for the module of words. A worker that waits before it listens loses the
// calls that are sent meanwhile.
const reader = () => import('./rhino-in.ts');
const writer = () => import('./rhino-out.ts');
type Reader = Awaited<ReturnType<typeof reader>>;
type Writer = Awaited<ReturnType<typeof writer>>;

const methods = {
  /** The mesh in a file, as OBJ. Hidden objects are in it if asked for. */
  read: async (...given: Parameters<Reader['meshFromRhino']>) =>
    (await reader()).meshFromRhino(...given),
  /** A scene with the table of its face errors, as a file. */
  write: async (...given: Parameters<Writer['rhinoFile']>) => (await writer()).rhinoFile(...given),
  /** The parts to be built, as a file. */
  writeParts: async (...given: Parameters<Writer['rhinoParts']>) =>
    (await writer()).rhinoParts(...given),
};
export type Rhino = typeof methods;

onmessage = async ({ data }: MessageEvent<Call>) =>
  postMessage(await answerTo(() => methods, data));
