/**
 * Worker that reads and writes Rhino files; it answers one request. It is separate because rhino3dm
 * creates functions from text, which the page's content security policy forbids, and so that a file
 * that crashes it stops nothing else.
 */

import { messageOf } from '../../solver/messages.js';
import { meshFromRhino } from './rhino-in.js';
import { rhinoFile } from './rhino-out.js';
import { rhinoParts } from './rhino-parts.js';

/** @typedef {import("../../solver/messages.js").RhinoRequest} RhinoRequest */
/** @typedef {import("../../solver/messages.js").RhinoAnswer} RhinoAnswer */

onmessage = async ({ data }) => {
  /** @type {RhinoAnswer} */
  const answer = await answerTo(data).catch((error) => ({ refused: messageOf(error) }));
  postMessage(answer);
};

/**
 * @param {RhinoRequest} request
 * @returns {Promise<RhinoAnswer>}
 */
async function answerTo(request) {
  if (request.type === 'read') return { value: await meshFromRhino(request.file) };
  if (request.type === 'writeParts')
    return { value: await rhinoParts(request.parts, request.symbol) };
  return { value: await rhinoFile(request.scene, request.errors) };
}
