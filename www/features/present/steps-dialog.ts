/** The dialog of a presentation: its steps in order, the content of each, and the start button. */

import './present.css';
import { openDialog } from '../../ui/controls/dialog.ts';
import { button, checkbox, choice, closeButton } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import { presentActions } from '../../store/present-actions.ts';
import { present } from './stage.ts';
import { drawShape } from '../../ui/plot/thumbnail.ts';
import type { Slide } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

export function openSteps(app: AppContext) {
  const { store, actions } = app;
  const slides = presentActions(store, actions);
  const savedSteps = () => store.get().document?.steps ?? [];
  /** The steps, also before the solver has answered: presses and typing can be quicker. */
  let steps = savedSteps();
  let saving: Promise<unknown> = Promise.resolve();
  const list = element('ol.steps');
  const said = element('p.quiet', { 'aria-live': 'polite' });
  const start = button('Start', () => begin(false), { class: 'primary' });
  const withNotes = button('Start with notes', () => begin(true), {
    title: 'Your notes open in a separate window: put it on a screen that only you see',
  });
  const add = button('Add this view', () =>
    change([...steps, slides.stepNow(`Step ${steps.length + 1}`)]),
  );

  function save(next: Slide[]) {
    steps = next;
    saving = slides.setSteps(next).then((done) => {
      if (done !== undefined) return;
      // Refused.
      steps = savedSteps();
      show();
    });
  }

  function change(next: Slide[]) {
    save(next);
    show();
  }

  /** @param notes in a window of their own */
  async function begin(notes: boolean) {
    dialog.close();
    await saving;
    return actions.reportErrors(present(app, notes));
  }

  const changed = (index: number, values: Partial<Slide>) =>
    steps.map((step, i) => (i === index ? { ...step, ...values } : step));

  /** Saves text without rebuilding the rows. */
  function say(index: number, words: Partial<Slide>) {
    save(changed(index, words));
    offer();
  }

  /** Enables the start buttons that apply. */
  function offer() {
    start.disabled = steps.length === 0;
    withNotes.hidden = !steps.some(({ notes }) => notes);
  }

  function move(index: number, by: number) {
    const moved = [...steps];
    const [step] = moved.splice(index, 1);
    moved.splice(index + by, 0, step);
    change(moved);
  }

  function row(step: Slide, index: number, all: number) {
    const number = index + 1;
    const title = element('input', {
      type: 'text',
      'aria-label': `Title of step ${number}`,
      value: step.title,
      onchange: () => say(index, { title: title.value }),
    });
    const text = element('textarea', {
      rows: 2,
      'aria-label': `Text of step ${number}`,
      placeholder: 'Text shown beside the model',
      onchange: () => say(index, { text: text.value }),
    });
    text.value = step.text ?? '';
    const notes = element('textarea', {
      rows: 1,
      'aria-label': `Notes of step ${number}`,
      placeholder: 'Notes that only you see',
      onchange: () => say(index, { notes: notes.value }),
    });
    notes.value = step.notes ?? '';
    const run = checkbox('Run', (run) => change(changed(index, { run })), {
      title: 'Runs the solver from this step',
    });
    run.box.checked = step.run ?? false;
    return element(
      'li',
      element('canvas', { role: 'img', 'aria-label': `Picture of step ${number}` }),
      element(
        'div',
        title,
        closeButton(`Remove step ${number}`, () => remove(index)),
      ),
      text,
      notes,
      element(
        'div',
        shapeOf(step, index),
        run.label,
        button('Replace by this view', () => take(index), {
          class: 'bordered small',
          title: 'The view, the measure and the weights as they are now',
        }),
        button('↑', () => move(index, -1), {
          class: 'small',
          'aria-label': `Step ${number} earlier`,
          disabled: index === 0,
        }),
        button('↓', () => move(index, 1), {
          class: 'small',
          'aria-label': `Step ${number} later`,
          disabled: index === all - 1,
        }),
      ),
    );
  }

  /** Selects the shape of a step. */
  function shapeOf(step: Slide, index: number) {
    const variants = store.get().document?.variants ?? [];
    const shape = choice(
      { 'aria-label': `Shape of step ${index + 1}` },
      (value) => {
        const original = value === 'original';
        const variant = original || value === '' ? undefined : Number(value);
        change(changed(index, { original, variant }));
      },
      [
        ['', 'Current shape'],
        ['original', 'The original'],
        ...variants.map((name, i) => [String(i), name]),
      ],
    );
    shape.value = step.original ? 'original' : String(step.variant ?? '');
    return shape;
  }

  function take(index: number) {
    const { title, text, notes, run } = steps[index];
    const step = { ...slides.stepNow(title), text, notes, run };
    change(steps.map((old, i) => (i === index ? step : old)));
  }

  const remove = (index: number) => change(steps.filter((_, i) => i !== index));

  function show() {
    list.replaceChildren(...steps.map((step, index) => row(step, index, steps.length)));
    const draw = stepPictures(app);
    list.querySelectorAll('canvas').forEach((canvas, index) => draw(canvas, steps[index]));
    offer();
    setText(
      said,
      steps.length === 0
        ? 'No steps yet. A step keeps the view, the measure and the weights as they are when it is added.'
        : `${count(steps.length, 'step')}, saved in the scene. Keys: → and ← or a presenter, B darkens, Space runs, Esc ends.`,
    );
  }

  const dialog = openDialog(
    { id: 'presentation', title: 'Presentation' },
    element('div.dialog-body', said, list, element('div.dialog-buttons', start, withNotes, add)),
  );
  show();
}

/** Indices of turn and tilt in the array of a camera. */
const [TURN, TILT] = [4, 5];

/**
 * Thumbnails of the steps: the shape of each, from its camera.
 * @returns draws a step into a canvas
 */
function stepPictures({
  store,
  solver,
}: Pick<AppContext, 'store' | 'solver'>): (canvas: HTMLCanvasElement, step: Slide) => void {
  const { mesh, variants } = JSON.parse(solver.sceneText ?? '{}');
  const { document: scene } = store.get();
  const shapeOf = ({ original, variant }: Slide) => {
    const kept = variant === undefined ? undefined : variants?.kept[variant]?.positions;
    const rows = original ? mesh?.positions : kept;
    return rows?.flat() ?? solver.geometry?.positions;
  };
  return (canvas, step) => {
    const { connectivity } = solver.geometry ?? {};
    const positions = shapeOf(step);
    if (!connectivity || !scene || !positions) return;
    const { camera } = step;
    const from = camera && { turn: camera[TURN], above: camera[TILT] };
    drawShape(canvas, connectivity, positions, { up: scene.up, from });
  };
}
