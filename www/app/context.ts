/**
 * Types of the objects that `main.ts` passes to the other folders. There is no code here, so every
 * folder may import them.
 */

import type { State, Store } from '../store/state.ts';
import type { JobsClient } from '../solver/jobs-client.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Viewport } from '../viewport/viewport.ts';
import type { Files } from '../documents/files.ts';
import type { Actions } from '../store/actions.ts';
import type { MeshActions } from '../store/mesh-actions.ts';
import type { Selecting } from '../store/mesh-queries.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';
import type { Startup } from './startup.ts';
import type { HoldOriginal } from '../features/hold-original.ts';

export interface Command {
  /** value of `data-command` */
  id: string;
  /** heading in the help */
  group: string;
  /** in the help */
  label: string;
  /** such as "Ctrl+Shift+Z"; letters are the characters printed on the keys */
  keys: string[];
  action: () => unknown;
  /** whether it is done again and again while its key is held: a step, not a switch */
  repeats?: boolean;
  /** whether a press waits until the first model is loaded */
  needsModel?: boolean;
  /** whether the palette leaves it out: what a key is held for, and the palette itself */
  unlisted?: boolean;
  /** always, if absent */
  enabled?: (state: State) => boolean;
  /** for toggle buttons */
  pressed?: (state: State) => boolean;
  /** tooltip, else the label */
  title?: (state: State) => string;
}

/** objects shared by the parts of the page */
export interface AppContext {
  store: Store;
  solver: SolverClient;
  /** the second worker */
  jobs: JobsClient;
  viewport: Viewport;
  files: Files;
  actions: Actions;
  mesh: MeshActions;
  selecting: Selecting;
  alerts: Alerts;
  hold: HoldOriginal;
  /** the works saved in this browser */
  works: Pick<Startup, 'recent' | 'openWork'>;
  /** the API for scripts */
  script: ReturnType<typeof import('./script-api.ts').scriptApi>;
  /** commands of selection operations are added later */
  commands: Command[];
}
