/**
 * Worker that reads and writes Rhino files. It is separate because rhino3dm creates functions from
 * text, which the page's content security policy forbids, and so that a file that crashes it stops
 * nothing else.
 */

import { answerTo, type Call } from '../../solver/remote.ts';

// The converter waits for the module of words. A worker that waits before it listens loses the calls
// that are sent meanwhile.
const converter = () => import('./rhino-converter.ts');

onmessage = async ({ data }: MessageEvent<Call>) => postMessage(await answerTo(converter, data));
