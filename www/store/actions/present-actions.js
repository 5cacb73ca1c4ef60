/** What the page can do with the steps of a presentation: it comes when somebody first asks. */

/** @typedef {import("../../solver/messages.js").Slide} Slide */

/**
 * @param {import("../state.js").Store} store
 * @param {import("../actions.js").Actions} actions
 */
export function presentActions(store, actions) {
  return {
    /** A step that shows what is seen now. @param {string} title @returns {Slide} */
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

    /**
     * Shows a step: its shape and weights are a step of undo where they are others.
     * @param {number} index
     */
    async showStep(index) {
      const { document: scene, running } = store.get();
      const step = scene?.steps[index];
      if (!step) return;
      const { camera, measure, parallel = false, original, variant, weights, run } = step;
      if (running && !run) actions.runOrPause();
      if (original || weights || variant !== undefined)
        await actions.edit({ type: 'showStep', index });
      // The other parts of the step hold, whatever became of its shape.
      actions.look({ parallel, measure: measure ?? null, measureChosen: true });
      if (camera) actions.look({ camera: [...camera] });
      if (run) actions.run();
    },
  };
}
