/** Adding a constraint: a dialog docked over the Model panel. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'add-constraint',
      group: 'Edit',
      label: 'Add constraint',
      keys: [],
      action: () => import('./dialog-add-constraint.js').then((it) => it.toggleAddConstraint(app)),
      needsModel: true,
    },
  ],
};
