/**
 * The worker that reads and writes files of Rhino. rhino3dm makes functions from text, which the policy
 * of the page refuses; and a file that it cannot cope with stops nothing else. It answers one request.
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
