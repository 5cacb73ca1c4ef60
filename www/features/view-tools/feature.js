/** Views, projection, ghost, ground grid, section plane and measuring tape. */

import { viewCommands } from './view-commands.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: viewCommands,
};
