/** The commands of the Select tool: box, lasso and brush, and selecting hidden elements. */

/** Factor of the brush keys; minimum and maximum radius of the brush in CSS pixels. */
const BRUSH_FACTOR = 1.25;
const BRUSH = [4, 120];

/**
 * @param {import("../../app/context.js").AppContext} app
 * @returns {import("../../app/context.js").Command[]}
 */
function commands({ store, actions }) {
  const shape = (
    /** @type {import("../../store/state.js").State["shape"]} */ id,
    /** @type {string} */ label,
    /** @type {string} */ key,
  ) => ({
    id: `shape-${id}`,
    group: 'Select',
    label,
    keys: [key],
    action: () => actions.useTool({ tool: 'select', shape: id }),
  });
  const brush = (
    /** @type {string} */ id,
    /** @type {string} */ label,
    /** @type {string} */ key,
    /** @type {number} */ factor,
  ) => ({
    id,
    group: 'Select',
    label,
    keys: [key],
    action: () => {
      const radius = Math.round(store.get().brush * factor);
      actions.useTool({ brush: Math.min(Math.max(radius, BRUSH[0]), BRUSH[1]) });
    },
  });
  return [
    shape('box', 'Select with a box', 'B'),
    shape('lasso', 'Select with a lasso', 'L'),
    shape('paint', 'Select with a brush', 'P'),
    brush('brush-smaller', 'Smaller brush', '[', 1 / BRUSH_FACTOR),
    brush('brush-larger', 'Larger brush', ']', BRUSH_FACTOR),
    {
      id: 'through',
      group: 'Select',
      label: 'Also select hidden elements',
      keys: ['T'],
      action: () => actions.useTool({ through: !store.get().through }),
    },
  ];
}

/** @type {import("../../app/context.js").Feature} */
export default { commands };
