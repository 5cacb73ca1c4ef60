/** The Edit mesh dialog: the operations that the solver declares, their sizes, and a preview. */

import './refine.css';
import { messageOf } from '../../solver/errors.ts';
import { meshActions } from '../../store/mesh-actions.ts';
import { newestOnly } from '../../store/newest-only.ts';
import { openDialog } from '../../ui/controls/dialog.ts';
import { button, choice } from '../../ui/controls/fields.ts';
import { sizeField } from '../../ui/controls/size-field.ts';
import { element, setText } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import { oneAtATime } from '../../ui/once.ts';
import type { AppContext } from '../../app/context.ts';
import type { RemeshingPreview } from '../../pkg/engine/shape_up.js';

/** The last operation, suggested for the next time. */
let last = '';

/**
 * Opens the dialog.
 * @param suggested the operation to begin with
 */
export const openEdit: (app: AppContext, suggested?: string) => Promise<void> | undefined =
  oneAtATime(open);

async function open({ store, solver, actions, alerts }: AppContext, suggested?: string) {
  const mesh = meshActions(store, solver, actions);
  const operations = await actions.ask.meshOperations();
  const { selection, document: scene } = store.get();
  const picked = { vertices: actions.selectedVertices(), faces: [...selection.faces] };
  const newest = newestOnly();

  const operation = choice(
    {},
    showSizes,
    operations.map(({ id, label }) => [id, label]),
  );
  const summary = element('p.quiet');
  const sizes = element('div.sizes');
  const said = element('p', { 'aria-live': 'polite' });
  const lost = element('ul.quiet');
  const apply = button('Apply', start, { class: 'primary' });

  const chosen = () => operations.find(({ id }) => id === operation.value) ?? operations[0];
  const fields = () => [...sizes.querySelectorAll('input')];
  const how = () => ({
    operation: chosen().id,
    sizes: fields().map((field) => field.valueAsNumber),
    ...picked,
  });

  function showSizes() {
    const { summary: words, sizes: declared, defaults } = chosen();
    setText(summary, words);
    const unit = scene?.units ?? '';
    sizes.replaceChildren(
      ...declared.map((size, i) => sizeField(size, { value: defaults[i], unit, onchange: show })),
    );
    void show();
  }

  /** Shows what the operation would produce. */
  async function show() {
    apply.disabled = true;
    lost.replaceChildren();
    const wrong = fields().find((field) => !field.validity.valid);
    if (wrong) {
      // The answer for the sizes before is out of date.
      void newest(null);
      const label = wrong.closest('label')?.firstChild?.textContent;
      return setText(said, `${label}: ${wrong.validationMessage}`);
    }
    try {
      const made = await newest(actions.ask.remeshing(how()));
      if (!made) return;
      setText(said, sentence(made));
      lost.replaceChildren(...made.lost.map((words) => element('li', words)));
      apply.disabled = false;
    } catch (error) {
      setText(said, `Not possible yet: ${messageOf(error)}.`);
    }
  }

  async function start() {
    const { label } = chosen();
    const asking = how();
    last = asking.operation;
    dialog.close();
    const notes = await actions.reportErrors(mesh.remesh(asking, label));
    if (notes?.length) alerts.notice(notes.join(' '));
  }

  // Set before the dialog is visible, so that it cannot replace the user's choice.
  operation.value = suggested || last || (await firstThatFits());
  const dialog = openDialog(
    { id: 'edit-mesh', title: 'Edit mesh', light: true },
    element(
      'div.dialog-body',
      element('label', element('span', 'Operation'), operation),
      summary,
      sizes,
      said,
      lost,
      element(
        'p.quiet',
        'The operation changes the shape as it is now. Sets, constraints and handles are carried over. It is one step of undo.',
      ),
      element('div.dialog-buttons', apply),
    ),
  );
  showSizes();

  /** The first operation that applies here. */
  async function firstThatFits() {
    for (const { id, defaults } of operations) {
      const made = actions.ask.remeshing({ ...picked, operation: id, sizes: defaults });
      if (await made.catch(() => null)) return id;
    }
    return operations[0].id;
  }
}

/** The result of an operation in words. */
function sentence({ vertices, faces, corners: [triangles, quads, larger] }: RemeshingPreview) {
  const kinds: [number, string][] = [
    [triangles, 'triangle'],
    [quads, 'quad'],
    [larger, 'larger face'],
  ];
  const words = kinds.filter(([number]) => number).map(([number, word]) => count(number, word));
  const of = words.length === 1 ? words[0] : `${count(faces[1], 'face')} (${words.join(', ')})`;
  const points = count(vertices[1], 'vertex', 'vertices');
  return `${count(faces[0], 'face')} become ${of}, with ${points}.`;
}
