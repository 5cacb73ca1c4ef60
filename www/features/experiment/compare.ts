/**
 * Compares methods on the open document: by the experiment of its example, or by the general one.
 */

import { ExperimentDialog } from './plots-dialog.ts';
import type { AppContext } from '../../app/context.ts';

export async function compareMethods(app: AppContext) {
  const { store, actions } = app;
  const { example, document: scene } = store.get();
  if (example?.experiment) {
    const { id, experiment, scene, mesh } = example;
    const made = [scene, mesh].map(async (name) => ({
      name,
      bytes: await actions.exampleFile(name),
    }));
    const of = { example: id, files: await Promise.all(made) };
    return new ExperimentDialog(experiment, { of, name: id }, app).open();
  }
  const experiment = await actions.comparison();
  const name = `${scene?.title || 'scene'} methods`;
  new ExperimentDialog(experiment, { of: null, name }, app).open();
}
