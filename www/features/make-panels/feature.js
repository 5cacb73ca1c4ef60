/** Actions on the whole mesh: one press for all panels, and changes of the mesh itself. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'edit-mesh',
      group: 'Edit',
      label: 'Edit mesh',
      keys: [],
      enabled: ({ model, document }) =>
        Boolean(model?.faces && !model.tets && !document?.lesson?.lock.includes('mesh')),
      action: () =>
        app.actions.reportErrors(import('./refine-operation.js').then((it) => it.openEdit(app))),
    },
  ],
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./card.js').then((it) => new it.MakePanels(app)),
    },
  ],
};
