/** Actions on the steps of a presentation. */

import type { Slide } from '../pkg/engine/shape_up.js';
import { newestOnly } from './latest-only.ts';
import type { Store } from './state.ts';
import type { Actions } from './actions.ts';

export function presentActions(store: Store, actions: Actions) {
  const newest = newestOnly(() => store.get().model);

  return {
    /** Returns a step that shows the current view. */
    stepNow(title: string): Slide {
      const { camera, parallel, measure, document: scene } = store.get();
      const step: Slide = { title };
      if (camera) step.camera = [...camera];
      if (parallel) step.parallel = true;
      if (measure) step.measure = measure;
      if (scene) step.weights = scene.weights;
      if (scene && scene.design !== null) step.variant = scene.design;
      return step;
    },

    setSteps: (steps: Slide[]) => actions.edit({ setSteps: { steps } }),

    /** Shows a step; a change of shape or weights is one step of undo. */
    async showStep(index: number) {
      const { document: scene, running } = store.get();
      const step = scene?.steps[index];
      if (!step) return;
      const { camera, measure, parallel = false, original, variant, weights, run } = step;
      if (running && !run) actions.runOrPause();
      const isSet = original || weights || variant !== undefined;
      const set = isSet ? actions.edit({ showStep: { index } }) : null;
      // Null also if it is refused: the remaining parts apply even then, to the model that it is of.
      if ((await newest(Promise.resolve(set).then(() => null))) === undefined) return;
      actions.look({ parallel, measure: measure ?? null, measureChosen: true });
      if (camera) actions.look({ camera: [...camera] });
      if (run) actions.run();
    },
  };
}
