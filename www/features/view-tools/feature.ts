/** Views, projection, ghost, ground grid, section plane and measuring tape. */

import { viewCommands } from './view-commands.ts';
import type { Feature } from '../../app/context.ts';

export default {
  commands: viewCommands,
} satisfies Feature;
