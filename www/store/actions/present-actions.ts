/** Actions on the steps of a presentation. Loaded on first use. */

import type { Slide } from '../../solver/types.ts';
import type { Store } from '../state.ts';
import type { Actions } from '../actions.ts';

export function presentActions(store: Store, actions: Actions) {
  /** Number of the latest step shown. */
  let latest = 0;

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

    setSteps: (steps: Slide[]) => actions.edit({ type: 'setSteps', steps }),

    /** Shows a step; a change of shape or weights is one step of undo. */
    async showStep(index: number) {
      const { document: scene, running } = store.get();
      const step = scene?.steps[index];
      if (!step) return;
      const mine = ++latest;
      const { camera, measure, parallel = false, original, variant, weights, run } = step;
      if (running && !run) actions.runOrPause();
      if (original || weights || variant !== undefined)
        await actions.edit({ type: 'showStep', index });
      if (mine !== latest) return;
      // The remaining parts apply even if the shape could not be set.
      actions.look({ parallel, measure: measure ?? null, measureChosen: true });
      if (camera) actions.look({ camera: [...camera] });
      if (run) actions.run();
    },
  };
}
