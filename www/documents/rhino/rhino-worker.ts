/**
 * Worker that reads and writes Rhino files; it answers one request. It is separate because rhino3dm
 * creates functions from text, which the page's content security policy forbids, and so that a file
 * that crashes it stops nothing else.
 */

import { messageOf, type RhinoRequest, type RhinoAnswer } from '../../solver/messages.ts';
import { meshFromRhino } from './rhino-in.ts';
import { rhinoFile } from './rhino-out.ts';
import { rhinoParts } from './rhino-parts.ts';

onmessage = async ({ data }) => {
  const answer: RhinoAnswer = await answerTo(data).catch((error) => ({
    refused: messageOf(error),
  }));
  postMessage(answer);
};

async function answerTo(request: RhinoRequest): Promise<RhinoAnswer> {
  if (request.type === 'read') return { value: await meshFromRhino(request.file) };
  if (request.type === 'writeParts')
    return { value: await rhinoParts(request.parts, request.symbol) };
  return { value: await rhinoFile(request.scene, request.errors) };
}
