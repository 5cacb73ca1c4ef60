/** Actions on the steps of a presentation. Loaded on first use. */

/** @typedef {import("../../solver/messages.js").Slide} Slide */

/**
 * @param {import("../state.js").Store} store
 * @param {import("../actions.js").Actions} actions
 */
export function presentActions(store, actions) {
  /** Number of the latest step shown. */
  let latest = 0;

  return {
    /** Returns a step that shows the current view. @param {string} title @returns {Slide} */
    stepNow(title) {
      const { camera, parallel, measure, document: scene } = store.get();
      /** @type {Slide} */
      const step = { title };
      if (camera) step.camera = [...camera];
      if (parallel) step.parallel = true;
      if (measure) step.measure = measure;
      if (scene) step.weights = scene.weights;
      if (scene && scene.design !== null) step.variant = scene.design;
      return step;
    },

    /** @param {Slide[]} steps */
    setSteps: (steps) => actions.edit({ type: 'setSteps', steps }),

    /** Shows a step; a change of shape or weights is one step of undo. @param {number} index */
    async showStep(index) {
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
