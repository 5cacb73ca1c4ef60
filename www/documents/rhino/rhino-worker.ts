/**
 * Worker that reads and writes Rhino files; it answers one request. It is separate because rhino3dm
 * creates functions from text, which the page's content security policy forbids, and so that a file
 * that crashes it stops nothing else.
 */

import { messageOf } from '../../solver/errors.ts';
import { meshFromRhino } from './rhino-in.ts';
import { rhinoFile } from './rhino-out.ts';
import { rhinoParts } from './rhino-parts.ts';
import type { NamedBytes, SpatialPart } from '../../solver/types.ts';

/**
 * Messages of the Rhino worker, which handles one request: read a file as the mesh in it, write a
 * scene with the table of its face errors, or write the parts to be built.
 */
export type RhinoRequest =
  | { type: 'read'; file: NamedBytes }
  | { type: 'write'; scene: string; errors: string }
  | { type: 'writeParts'; parts: SpatialPart[]; symbol: string };

export type RhinoReplies = {
  read: NamedBytes;
  write: Uint8Array<ArrayBuffer>;
  writeParts: Uint8Array<ArrayBuffer>;
};

type RhinoAnswer = { value: RhinoReplies[keyof RhinoReplies] } | { refused: string };

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
