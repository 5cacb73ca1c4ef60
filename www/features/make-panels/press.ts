/** One press for all panels: the run, its transition, and commands for it. */

import { endOfRun } from '../../store/end-of-run.ts';
import { isLocked } from '../../store/panels-card.ts';
import type { KindWords, PanelStart } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';
import type { State } from '../../store/state.ts';

/** Minimum duration of the transition: a jump would not show what changes. */
const TRANSITION_MS = 800;
const still = matchMedia('(prefers-reduced-motion: reduce)');

interface How {
  /** the shape to start from */
  from?: PanelStart;
  /** the tolerance, if other than the displayed one */
  within?: number;
  /** of the better choice that was pressed */
  label?: string;
}

/**
 * Makes all panels of this kind, with a transition. While a model is being opened, a press without
 * `how` is meant for that one; any other is about the open model.
 */
export async function makePanels(app: AppContext, kind: KindWords, how?: How) {
  const { from = 'now', within, label = '' } = how ?? {};
  const { store, solver, viewport, actions, files } = app;
  if (files.openings.coming && !(await isMeantAfter(app, kind.id, !how))) return;
  const before = store.get();
  if (!before.model) return;
  const press = { isUnderWay: true, label };
  actions.pressed(press);
  const settle = () => actions.updatePress(press, { isUnderWay: false });
  const arrived = still.matches ? null : viewport.transition(TRANSITION_MS);
  const show = (shown: boolean) => actions.look({ fitted: shown });
  // The fitted shapes are those of the final shape.
  if (arrived) show(false);
  const { ended, stop } = endOfRun(solver);
  const shape = solver.geometry?.generation;
  // A shape that stays as it is has no transition.
  void ended.then(() => solver.geometry?.generation === shape && viewport.endTransition());
  if ((await actions.makePanels(kind.id, within, from)) === undefined) {
    stop();
    viewport.endTransition();
    return actions.pressRefused(press, before);
  }
  await arrived;
  // Another file, and who has chosen meanwhile, have them as they are.
  if (!arrived || store.get().fitted !== null) show(true);
  await ended;
  settle();
}

/**
 * Waits for what is being opened. Returns whether the press is meant for the model that is open then.
 * @param forNext whether it is for the next one, whose panels have to take this kind
 */
async function isMeantAfter({ store, files }: AppContext, id: string, forNext: boolean) {
  const { model: before } = store.get();
  await files.untilOpen();
  const { model } = store.get();
  if (!forNext) return model === before;
  const offered = model?.panels.find(({ kind }) => kind === id);
  return model !== before && offered !== undefined && !offered.reason;
}

/** Adds the commands that make all panels one shape, once the solver has declared the kinds. */
export function offerPanelCommands(app: AppContext) {
  let isOffered = false;
  app.store.subscribe(['kinds'], ({ kinds }) => {
    // A solver that was started again declares the same.
    if (isOffered || kinds.length === 0) return;
    isOffered = true;
    const own = kinds.filter(({ panels }) => panels !== null);
    const made = own.map((kind) => ({
      id: `make-${kind.id}`,
      group: 'Shape',
      label: `Make panels ${kind.panels}`,
      keys: [],
      needsModel: true,
      enabled: ({ model, document }: Readonly<State>) =>
        !isLocked({ document }, 'constraints') &&
        model?.panels.find((one) => one.kind === kind.id)?.reason === null,
      action: () => makePanels(app, kind),
    }));
    app.commands.push(...made);
  });
}
