/** A link to the scene. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'share',
      group: 'File',
      label: 'Share a link to the scene',
      keys: [],
      action: () => import('./dialog-share.js').then((it) => it.share(app)),
      needsModel: true,
    },
  ],
};
