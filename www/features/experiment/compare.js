/**
 * Compares methods on the open document: by the experiment of its example, or by the general one.
 */

import { exampleFile } from '../../solver/examples.js';
import { ExperimentDialog } from './plots-dialog.js';

/** @param {import("../../app/context.js").AppContext} app */
export async function compareMethods(app) {
  const { store, actions } = app;
  const { example, document: scene } = store.get();
  if (example?.experiment) {
    const { id, experiment, scene, mesh } = example;
    const fetched = [scene, mesh].map(async (name) => ({ name, bytes: await exampleFile(name) }));
    const of = { example: id, files: await Promise.all(fetched) };
    return new ExperimentDialog(experiment, { of, name: id }, app).open();
  }
  const experiment = await actions.comparison();
  const name = `${scene?.title || 'scene'} methods`;
  new ExperimentDialog(experiment, { of: null, name }, app).open();
}
