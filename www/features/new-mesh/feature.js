/** A new mesh from a kind and its sizes. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'new-mesh',
      group: 'File',
      label: 'New mesh',
      keys: [],
      action: () => import('./dialog-new-mesh.js').then((it) => it.newMesh(app)),
    },
  ],
};
