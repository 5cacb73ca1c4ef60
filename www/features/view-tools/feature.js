/** Views, projection, ghost, ground, and the measuring tape. */

import { viewCommands } from './view-commands.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: viewCommands,
};
