/** Sheets of parts, and the check whether they can be built. All of it comes when it is first asked for. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'build',
      group: 'File',
      label: 'Parts on sheets',
      keys: [],
      action: () =>
        app.actions.reportErrors(import('./build-panel.js').then((it) => it.toggleBuild(app))),
      needsModel: true,
      enabled: ({ model }) => Boolean(model?.faces),
      pressed: ({ build }) => build !== null,
    },
  ],
};
