/** The dialog in which a teacher writes a lesson: a text, goals, and how the class gets it. */

import './lesson.css';
import { openDialog } from '../../ui/controls/dialog.js';
import { button, choice, closeButton } from '../../ui/controls/fields.js';
import { element, setText } from '../../ui/dom.js';
import { declared, measureOfScene, toleranceOf } from '../../store/colours/measures.js';
import { messageOf } from '../../solver/messages.js';

const UNITS = { percent: '%', degrees: '°', number: '' };
const ERROR_AT = /^goals\[(\d+)\]/;

/**
 * @param {import("../../app/context.js").AppContext} app
 */
export function write(app) {
  const { store, files, actions } = app;
  const share = () => app.commands.find(({ id }) => id === 'share')?.action();
  const state = store.get();
  const scene = state.document;
  if (!scene) return;
  const units = scene.units || 'unit of the mesh';
  const about = [
    ...(state.model?.faces ? state.measures : []).map((measure) => ({
      value: `measure ${measure.id}`,
      label: measure.label,
      unit: measure.unit === 'length' ? units : UNITS[measure.unit],
    })),
    ...[...new Set(scene.constraints.map(({ label }) => label))].map((label) => ({
      value: `constraint ${label}`,
      label: `Constraint: ${label}`,
      unit: units,
    })),
  ];

  const text = element('textarea', { rows: 5, id: 'lesson-words', required: true });
  text.value = scene.lesson?.text ?? '';
  const list = element('ul', { 'aria-label': 'Goals of the lesson' });
  const error = element('p.refused', { 'aria-live': 'assertive' });
  /** @type {{ row: HTMLElement, of: HTMLSelectElement, most: HTMLInputElement, unit: HTMLElement, remove: HTMLElement }[]} */
  let goals = [];

  /**
   * @param {string} value what it is about
   * @param {number | null} atMost
   */
  function addGoal(value, atMost) {
    const of = choice(
      {},
      () => showUnit(),
      about.map(({ value, label }) => [value, label]),
    );
    if (about.some((one) => one.value === value)) of.value = value;
    const most = element('input', { type: 'number', min: '0', step: 'any', required: true });
    if (atMost !== null) most.value = String(atMost);
    const unit = element('span.unit');
    const remove = closeButton('', () => {
      goals = goals.filter((goal) => goal.of !== of);
      row.remove();
      nameGoals();
      add.focus();
    });
    const row = element('li', 'worst', of, 'at most', most, unit, remove);
    function showUnit() {
      setText(unit, about.find((one) => one.value === of.value)?.unit ?? '');
      nameGoals();
    }
    goals.push({ row, of, most, unit, remove });
    list.append(row);
    showUnit();
  }

  /** Whoever does not see the rows hears which goal a control is of, and what it is about. */
  function nameGoals() {
    goals.forEach(({ of, most, unit, remove }, at) => {
      const goal = `Goal ${at + 1}`;
      const what = `${goal}: ${of.selectedOptions[0]?.label.toLowerCase() ?? ''}`;
      of.setAttribute('aria-label', `${goal}: worst`);
      most.setAttribute('aria-label', `${what} at most, ${unit.textContent}`.replace(/, $/, ''));
      remove.setAttribute('aria-label', `Remove ${what}`);
    });
  }

  const addEmpty = () => {
    addGoal(first, null);
    goals.at(-1)?.of.focus();
  };
  const add = button('Add goal', addEmpty, { disabled: about.length === 0 });
  const asked = declared(state, state.measure ?? measureOfScene(state));
  const first = `measure ${asked?.id ?? ''}`;
  for (const { measure, label, atMost } of scene.lesson?.goals ?? []) {
    addGoal(measure ? `measure ${measure}` : `constraint ${label}`, atMost);
  }
  if (goals.length === 0 && about.length > 0)
    addGoal(first, asked ? toleranceOf(state, asked) : null);

  /** Makes the scene this lesson, as one step of undo; then gives it on. @param {(() => unknown)} [then] */
  async function keep(then) {
    if (!form.reportValidity()) return;
    const lesson = {
      text: text.value.trim(),
      goals: goals.map(({ of, most }) => {
        const [what, ...name] = of.value.split(' ');
        return { [what]: name.join(' '), at_most: most.valueAsNumber };
      }),
    };
    const kept = await actions.edit({ type: 'setLesson', lesson }, (refused) => {
      const path = refused instanceof Error && 'path' in refused ? String(refused.path) : '';
      setText(error, messageOf(refused));
      goals[Number(ERROR_AT.exec(path)?.[1])]?.most.focus();
      return true;
    });
    if (kept === undefined) return;
    dialog.close();
    actions.setStatus('The scene is a lesson');
    then?.();
  }

  async function forget() {
    dialog.close();
    if ((await actions.edit({ type: 'setLesson', lesson: null })) !== undefined)
      actions.setStatus('Lesson removed');
  }

  const form = element(
    'form.dialog-body',
    { method: 'dialog' },
    element('label', { for: 'lesson-words' }, 'Task'),
    text,
    element('h3', 'Goals'),
    list,
    element('div', add),
    element(
      'p.quiet',
      'Students see the text and whether each goal is met while they work. They start from the scene as it is now. A constraint at most 0 is to be exact.',
    ),
    error,
    element(
      'div.dialog-buttons',
      button('Save lesson', () => keep(), { class: 'primary' }),
      button('Lesson as a scene file', () => keep(() => files.saveScene())),
      button('Lesson as a link', () => keep(share)),
      scene.lesson && button('Remove lesson', forget),
    ),
  );
  // Enter in a field of a goal is not the end of the dialog.
  form.addEventListener('submit', (event) => event.preventDefault());
  const dialog = openDialog({ id: 'lesson-dialog', title: 'Lesson' }, form);
  text.focus();
}
