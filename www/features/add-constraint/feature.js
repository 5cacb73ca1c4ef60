/** Adding a constraint: a dialog in the place of the panel of the model. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'add-constraint',
      group: 'Edit',
      label: 'Add constraint',
      keys: [],
      action: () =>
        app.actions.reportErrors(
          import('./dialog-add-constraint.js').then((it) => it.toggleAddConstraint(app)),
        ),
      needsModel: true,
    },
  ],
};
