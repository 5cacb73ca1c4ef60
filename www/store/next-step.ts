/** The next step that the page proposes: its button is filled, and the status bar names it. */

import { TOPIC_KEYS, isLocked, panelsTopic } from './panels-card.ts';
import type { State } from './state.ts';

/** What is needed to know it. */
export const NEXT_STEP_KEYS = [
  ...TOPIC_KEYS,
  'running',
  'converged',
  'numbers',
  'verdict',
] as const;

/**
 * - `shape`: nothing is constrained yet, and there are panels
 * - `change`: as before, but another mesh is needed or suggested first
 * - `constrain`: nothing is constrained or held yet, and no press is for these faces
 * - `run`: it runs, constraints are not met or cannot be added, or nothing can be built
 * - `choose`: a run has ended, but its shape is not good: something is beyond the tolerance, or its
 *   verdict, if not closed, offers better ones
 * - `build`: all is met
 */
export type NextStep = 'shape' | 'change' | 'constrain' | 'run' | 'choose' | 'build';

type Known = Pick<State, (typeof NEXT_STEP_KEYS)[number]>;

export function nextStep(state: Known): NextStep {
  const { document, model, running, converged, numbers } = state;
  if (running) return 'run';
  if (!document?.constraints.some(({ enabled }) => enabled)) {
    if (isLocked({ document }, 'constraints')) return 'run';
    if (model?.panels.some(({ reason }) => !reason)) return 'shape';
    if (document?.handles.length) return 'run';
    return model?.panelSuggestion ? 'change' : 'constrain';
  }
  if (!converged || numbers?.exact?.met === false || !model?.faces) return 'run';
  const isBeyond = document.constraints.some(
    ({ enabled, require }, row) =>
      enabled && require === 'soft' && (numbers?.worst[row] ?? 0) > document.tolerance,
  );
  const verdict = panelsTopic(state) === 'verdict' ? state.verdict : null;
  const isNotGood = verdict && verdict.report.level !== 'good';
  return isBeyond || isNotGood ? 'choose' : 'build';
}
