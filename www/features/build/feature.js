/** Sheets of parts, and the check whether they can be built. Loaded on first use. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'build',
      group: 'File',
      label: 'Parts on sheets',
      keys: [],
      action: () => import('./build-panel.js').then((it) => it.toggleBuild(app)),
      needsModel: true,
      pressed: ({ build }) => build !== null,
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.lesson?.goals.some(({ build }) => build)),
      load: (app) =>
        import('./build-goals.js').then((it) => app.actions.reportErrors(it.buildGoals(app))),
    },
  ],
};
