/** The Edit mesh dialog: the operations that the solver declares, their sizes, and a preview. */

import './refine.css';
import { useState } from 'preact/hooks';
import { refusalOf } from '../../solver/errors.ts';
import { CommandButton } from '../../store/command-button.tsx';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useAnswerTo } from '../../store/use-answer.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { SizeField } from '../../ui/components/size-field.tsx';
import { count } from '../../ui/words.ts';
import { oneAtATime } from '../../ui/once.ts';
import type { AppContext } from '../../app/context.ts';
import type { Remeshing, RemeshingPreview } from '../../pkg/engine/shape_up.js';

type Operations = Awaited<ReturnType<AppContext['actions']['ask']['meshOperations']>>;
type Picked = Pick<Remeshing, 'vertices' | 'faces'>;

/** The last operation, suggested for the next time. */
let last = '';

/**
 * Opens the dialog.
 * @param suggested the operation to begin with
 */
export const openEdit: (app: AppContext, suggested?: string) => Promise<void> | undefined =
  oneAtATime(async (app, suggested = '') => {
    const { store, actions } = app;
    const operations = await actions.ask.meshOperations();
    const picked = {
      vertices: actions.selectedVertices(),
      faces: [...store.get().selection.faces],
    };
    // Known before the dialog is visible, so that it cannot replace the user's choice.
    const first = suggested || last || (await firstThatFits(app, operations, picked));
    showDialog(app, { id: 'edit-mesh', title: 'Edit mesh', light: true }, ({ close }) => (
      <EditDialog close={close} operations={operations} picked={picked} first={first} />
    ));
  });

/** The first operation that applies here. */
async function firstThatFits({ actions }: AppContext, operations: Operations, picked: Picked) {
  for (const { id, defaults } of operations) {
    const made = actions.ask.remeshing({ ...picked, operation: id, sizes: defaults });
    if (await made.catch(() => null)) return id;
  }
  return operations[0].id;
}

function EditDialog({
  close,
  operations,
  picked,
  first,
}: InDialog & { operations: Operations; picked: Picked; first: string }) {
  const { store, actions, mesh } = useApp();
  const operationOf = (id: string) => operations.find((one) => one.id === id) ?? operations[0];
  const [asked, setAsked] = useState(() => beginWith(operationOf(first)));
  const { operation, sizes, problems } = asked;
  const wrong = problems.find(Boolean) ?? '';
  const { label, summary, sizes: declared } = operationOf(operation);
  const { words, lost, isReady } = usePreview(operation, sizes, picked, wrong);
  const units = store.state.document?.units ?? '';

  function apply() {
    last = operation;
    close();
    void actions.reportErrors(mesh.remesh({ operation, sizes, ...picked }, label));
  }

  return (
    <div class="dialog-body">
      <label>
        <span>Operation</span>
        <Choice
          value={operation}
          options={operations.map((one) => [one.id, one.label] as const)}
          onChoose={(id) => setAsked(beginWith(operationOf(id)))}
        />
      </label>
      <p class="quiet">{summary}</p>
      <div class="sizes">
        {declared.map((size, i) => (
          <SizeField
            key={`${operation} ${size.label}`}
            size={size}
            value={sizes[i]}
            unit={units}
            onSize={(value, problem) =>
              setAsked({
                operation,
                sizes: sizes.with(i, value),
                problems: problems.with(i, problem && `${size.label}: ${problem}`),
              })
            }
          />
        ))}
      </div>
      <p aria-live="polite">{words}</p>
      <ul class="quiet">
        {lost.map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
      <p class="quiet">
        The operation changes the shape as it is now. Sets, constraints and handles are carried
        over, except those that are listed as left out. One Undo takes it back.
      </p>
      <div class="dialog-buttons">
        <Button class="primary" disabled={!isReady} onClick={apply}>
          Apply
        </Button>
        <CommandButton of="new-panels" onClick={close}>
          New panels
        </CommandButton>
      </div>
    </div>
  );
}

/** An operation with its default sizes, and what is wrong with each of them. */
const beginWith = ({ id, defaults }: Operations[number]) => ({
  operation: id,
  sizes: defaults,
  problems: defaults.map(() => ''),
});

/**
 * What the operation would produce, what would be lost, and whether that is known.
 * @param wrong with the sizes, in words; empty if nothing is
 */
function usePreview(operation: string, sizes: number[], picked: Picked, wrong: string) {
  const { ask } = useApp().actions;
  const refused = (words: string) => ({ words, lost: [] as string[], isReady: false });
  const { answer = refused(''), isCurrent } = useAnswerTo([operation, sizes, wrong], async () => {
    if (wrong) return refused(wrong);
    return ask.remeshing({ operation, sizes, ...picked }).then(
      (made) => ({ words: sentence(made), lost: made.lost, isReady: true }),
      (error) => refused(refusalOf(error, 'Not possible yet')),
    );
  });
  return isCurrent ? answer : refused(answer.words);
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
  return `${count(faces[0], 'face becomes', 'faces become')} ${of}, with ${points}.`;
}
