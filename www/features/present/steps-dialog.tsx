/** The dialog of a presentation: its steps in order, the content of each, and the start button. */

import './present.css';
import { useMemo, useRef } from 'preact/hooks';
import { presentActions } from '../../store/present-actions.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { Checkbox, Choice } from '../../ui/components/fields.tsx';
import { TextField } from '../../ui/components/text-field.tsx';
import { Thumbnail } from '../../ui/components/thumbnail.tsx';
import { useEntered } from '../../ui/components/use-entered.ts';
import { TILT, TURN } from '../../viewport/flight.ts';
import { sceneOf } from '../../solver/scene-text.ts';
import { count } from '../../ui/words.ts';
import type { Slide } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';

export function openSteps(app: AppContext) {
  showDialog(app, { id: 'presentation', title: 'Presentation' }, StepsDialog);
}

function StepsDialog({ close }: InDialog) {
  const { store, solver, actions } = useApp();
  const slides = useMemo(() => presentActions(store, actions), []);
  const { over, enter } = useEntered<Slide[]>();
  const saving = useRef<Promise<unknown>>(Promise.resolve());
  const { document: scene, dark } = store.state;
  const { connectivity } = solver.geometry ?? {};
  const shapes = useMemo(() => shapesIn(solver.sceneText), [scene]);
  const steps = over(scene?.steps ?? []);

  /** @param made from the steps as they are at the press */
  function change(made: (steps: Slide[]) => Slide[]) {
    const next = made(over(store.get().document?.steps ?? []));
    const edit = slides.setSteps(next);
    enter(next, edit);
    saving.current = edit;
  }
  const changeStep = (index: number, values: Partial<Slide>) =>
    change((all) => all.with(index, { ...all[index], ...values }));

  const move = (index: number, by: number) =>
    change((all) => all.toSpliced(index, 1).toSpliced(index + by, 0, all[index]));

  async function begin() {
    close();
    await saving.current;
    actions.look({ presenting: true });
  }

  /** The shape of a step, unless a run changes it before. */
  function shapeOf(index: number): ArrayLike<number> {
    const { original, variant = -1 } = steps.slice(0, index + 1).findLast(saysShape) ?? {};
    const said = original ? shapes.original : shapes.kept[variant];
    return said ?? solver.geometry?.positions ?? [];
  }

  return (
    <div class="dialog-body">
      <p class="quiet" aria-live="polite">
        {steps.length === 0
          ? 'No steps yet. A step keeps the view, the measure and the weights as they are when it is added.'
          : `${count(steps.length, 'step')}, saved in the scene. Keys: → and ← or a presenter, B darkens, T hides the title, Space runs, Esc ends.`}
      </p>
      <ol class="steps">
        {steps.map((step, i) => (
          <li key={i}>
            {connectivity && scene && (
              <Thumbnail
                label={`Picture of step ${i + 1}`}
                connectivity={connectivity}
                shape={shapeOf(i)}
                up={scene.up}
                from={directionOf(step)}
                dark={dark}
              />
            )}
            <div>
              <TextField
                aria-label={`Title of step ${i + 1}`}
                value={step.title}
                onText={(title) => changeStep(i, { title })}
              />
              <CloseButton
                label={`Remove step ${i + 1}`}
                onClick={() => change((all) => all.toSpliced(i, 1))}
              />
            </div>
            <TextField
              aria-label={`Text of step ${i + 1}`}
              rows={2}
              placeholder="Text shown beside the model"
              value={step.text ?? ''}
              onText={(text) => changeStep(i, { text })}
            />
            <TextField
              aria-label={`Notes of step ${i + 1}`}
              rows={1}
              placeholder="Notes, not shown in the presentation"
              value={step.notes ?? ''}
              onText={(notes) => changeStep(i, { notes })}
            />
            <div>
              <Choice
                aria-label={`Shape of step ${i + 1}`}
                value={step.original ? 'original' : String(step.variant ?? '')}
                options={[
                  [
                    '',
                    steps.slice(0, i).some(saysShape)
                      ? 'As the step before leaves it'
                      : 'Current shape',
                  ],
                  ['original', 'The original'],
                  ...(scene?.variants ?? []).map((name, k) => [String(k), name] as const),
                ]}
                onChoose={(value) => {
                  const original = value === 'original';
                  const variant = original || value === '' ? undefined : Number(value);
                  changeStep(i, { original, variant });
                }}
              />
              <Checkbox
                label="Run"
                title="Runs the solver from this step"
                checked={step.run ?? false}
                onCheck={(run) => changeStep(i, { run })}
              />
              <Button
                class="bordered small"
                title="The view, the measure and the weights as they are now"
                onClick={() =>
                  change((all) => {
                    const { title, text, notes, run, original, variant } = all[i];
                    const kept = { text, notes, run, original, variant };
                    return all.with(i, { ...slides.stepNow(title), ...kept });
                  })
                }
              >
                Replace by this view
              </Button>
              <Button
                class="small"
                aria-label={`Step ${i + 1} earlier`}
                disabled={i === 0}
                onClick={() => move(i, -1)}
              >
                ↑
              </Button>
              <Button
                class="small"
                aria-label={`Step ${i + 1} later`}
                disabled={i === steps.length - 1}
                onClick={() => move(i, 1)}
              >
                ↓
              </Button>
            </div>
          </li>
        ))}
      </ol>
      <div class="dialog-buttons">
        <Button class="primary" disabled={steps.length === 0} onClick={begin}>
          Start
        </Button>
        <Button onClick={() => change((all) => [...all, slides.stepNow(`Step ${all.length + 1}`)])}>
          Add this view
        </Button>
      </div>
    </div>
  );
}

const directionOf = ({ camera }: Slide) => camera && { turn: camera[TURN], above: camera[TILT] };

/** Whether a step says what shape it shows: without it, that of the step before stays. */
const saysShape = ({ original, variant }: Slide) => original || variant !== undefined;

/** The original and the kept shapes of a scene, `#V by 3`, of which the steps show some. */
function shapesIn(text: string | null) {
  const scene = text === null ? null : sceneOf(text);
  const kept = scene?.variants?.kept ?? [];
  return {
    original: scene?.mesh.positions.flat(),
    kept: kept.map(({ positions }) => positions.flat()),
  };
}
