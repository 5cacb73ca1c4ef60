/** Exports of the current shape as mesh files, with the edits that were begun before. */

import { askToExport } from './collapse.tsx';
import { askRhino } from './rhino/rhino-client.ts';
import type { AppContext } from '../app/context.ts';

/**
 * Saves a file, after a question if the last run has collapsed the mesh.
 * @param type after `model/`
 */
function exportShape(app: AppContext, ending: string, type: string, make: () => Promise<BlobPart>) {
  const { actions, files } = app;
  return files.save(ending, `model/${type}`, async () => {
    await actions.settled();
    const collapse = await actions.ask.collapse();
    return !collapse || (await askToExport(app, collapse)) ? make() : null;
  });
}

/** Exports it as OBJ, with the displayed flat map. */
export const exportMesh = (app: AppContext) =>
  exportShape(app, '.obj', 'obj', () => {
    const uv = app.store.get().flatMap?.found.uv;
    const { ask } = app.actions;
    return uv ? ask.objWithUv(uv) : ask.obj();
  });

/** Exports it with the file's original vertices, before welding. */
export const exportUnwelded = (app: AppContext) =>
  exportShape(app, '.obj', 'obj', () => app.actions.ask.objUnwelded());

/** Exports it in the format with this ending. */
export const exportAs = (app: AppContext, ending: 'ply' | 'stl') =>
  exportShape(app, `.${ending}`, ending, () => app.actions.ask.meshFile(ending));

/** Exports it as a Rhino file, loading its large writer. */
export const exportForRhino = (app: AppContext) =>
  exportShape(app, '.3dm', 'vnd.3dm', async () => {
    const { ask } = app.actions;
    // Of the same shape.
    const [scene, errors] = await Promise.all([ask.scene(), ask.table('errors')]);
    return askRhino((rhino) => rhino.write(scene, errors));
  });
