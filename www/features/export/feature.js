/** Export in formats other than OBJ. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'export-as',
      group: 'File',
      label: 'More formats: Rhino, tables, pictures',
      keys: ['Ctrl+Shift+E'],
      action: () => import('./dialog-export.js').then((it) => it.showExport(app)),
      needsModel: true,
    },
  ],
};
