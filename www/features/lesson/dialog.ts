/** The dialog for writing a lesson: its text, goals and locks, and its export for a class. */

import './lesson.css';
import { openDialog } from '../../ui/controls/dialog.ts';
import { button, checkbox, choice, closeButton } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { declared, toleranceOf, unitOf } from '../../store/colours/measures.ts';
import { length, lengthUnit } from '../../ui/format.ts';
import { messageOf } from '../../solver/errors.ts';
import { LOCKS } from './panel.ts';
import type { AppContext } from '../../app/context.ts';

const ERROR_AT = /^lesson\.goals\[(\d+)\]/;

export async function write(app: AppContext) {
  const { store, files, actions } = app;
  const share = () => app.commands.find(({ id }) => id === 'share')?.action();
  const state = store.get();
  const scene = state.document;
  if (!scene) return;
  // Goals are written in the unit of the tolerance.
  const numbers = state.model?.faces ? await actions.ask.buildNumbers() : [];
  const { unit, factor } = lengthUnit(scene.tolerance, scene.units);
  const lengths = { unit: unit || 'unit of the mesh', factor };
  // Signed measures are not errors.
  const errors = state.measures.filter(({ signed }) => !signed);
  const measures = state.model?.faces ? errors : [];
  const about: { value: string; label: string; unit: string; factor: number; goal: object }[] = [
    ...measures.map((measure) => ({
      value: `measure ${measure.id}`,
      label: measure.label,
      ...(measure.unit === 'length' ? lengths : unitOf(measure, 1, scene.units)),
      goal: { measure: measure.id },
    })),
    ...measures
      .filter(({ toleranced }) => toleranced)
      .map(({ id }) => counting(id, scene.tolerance)),
    ...[...new Set(scene.constraints.map(({ label }) => label))].map((label) => ({
      value: `constraint ${label}`,
      label: `Constraint: ${label}`,
      ...lengths,
      goal: { constraint: label },
    })),
    ...numbers.map(({ id, label, unit }) => ({
      value: `build ${id}`,
      label: `Build: ${label}`,
      ...(unit === 'length' ? lengths : { unit: unit === 'degrees' ? '°' : '', factor: 1 }),
      goal: { build: id },
    })),
  ];

  /**
   * The goal that counts faces beyond a length.
   * @param id of the measure
   */
  function counting(id: string, beyond: number) {
    const label = declared(state, id)?.label ?? id;
    return {
      value: `beyond ${beyond} ${id}`,
      label: `Panels beyond ${length(beyond, scene?.units ?? '')}: ${label}`,
      unit: 'panels',
      factor: 1,
      goal: { measure: id, beyond },
    };
  }

  const text = element('textarea', { rows: 5, id: 'lesson-words', required: true });
  text.value = scene.lesson?.text ?? '';
  const list = element('ul', { 'aria-label': 'Goals of the lesson' });
  const error = element('p.refused', { 'aria-live': 'assertive' });
  let goals: {
    row: HTMLElement;
    of: HTMLSelectElement;
    most: HTMLInputElement;
    unit: HTMLElement;
    remove: HTMLElement;
  }[] = [];

  /** @param value id of the option */
  function addGoal(value: string, atMost: number | null) {
    const of = choice(
      {},
      () => showUnit(),
      about.map(({ value, label }) => [value, label]),
    );
    if (about.some((one) => one.value === value)) of.value = value;
    const most = element('input', { type: 'number', min: '0', step: 'any', required: true });
    const chosen = () => about.find((one) => one.value === of.value);
    if (atMost !== null)
      most.value = String(Number((atMost * (chosen()?.factor ?? 1)).toPrecision(12)));
    const unit = element('span.unit');
    const remove = closeButton('', () => {
      goals = goals.filter((goal) => goal.of !== of);
      row.remove();
      nameGoals();
      add.focus();
    });
    const row = element('li', 'worst', of, 'at most', most, unit, remove);
    function showUnit() {
      setText(unit, chosen()?.unit ?? '');
      nameGoals();
    }
    goals.push({ row, of, most, unit, remove });
    list.append(row);
    showUnit();
  }

  /** Labels the controls for screen readers with the number and subject of their goal. */
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
  const asked = declared(state, state.measure ?? scene.measure);
  const first = `measure ${asked?.id ?? ''}`;
  for (const { measure, build, label, atMost, beyond } of scene.lesson?.goals ?? []) {
    if (measure && beyond !== null) {
      const counted = counting(measure, beyond);
      if (!about.some(({ value }) => value === counted.value)) about.push(counted);
      addGoal(counted.value, atMost);
    } else {
      const other = build ? `build ${build}` : `constraint ${label}`;
      addGoal(measure ? `measure ${measure}` : other, atMost);
    }
  }
  if (goals.length === 0 && about.length > 0)
    addGoal(first, asked ? toleranceOf(state, asked) : null);

  /** Saves the lesson in one undo step, then calls `then`. */
  async function keep(then?: () => unknown) {
    if (!form.reportValidity()) return;
    const lesson = {
      text: text.value.trim(),
      goals: goals.map(({ of, most }) => {
        const { goal, factor } = about.find(({ value }) => value === of.value) ?? about[0];
        return { ...goal, at_most: most.valueAsNumber / factor };
      }),
      lock: locks.filter(({ box }) => box.checked).map(({ id }) => id),
    };
    const edit = { setLesson: { lesson, unsolved: unsolved.box.checked } };
    const kept = await actions.edit(edit, (refused) => {
      const path = refused instanceof Error && 'path' in refused ? String(refused.path) : '';
      setText(error, messageOf(refused));
      goals[Number(ERROR_AT.exec(path)?.[1])]?.most.focus();
      return true;
    });
    if (kept === undefined) return;
    dialog.close();
    actions.setStatus('Lesson saved in the scene');
    then?.();
  }

  const locks = LOCKS.map(([id, label]) => ({ id, ...checkbox(label, () => {}) }));
  for (const { id, box } of locks) box.checked = scene.lesson?.lock.includes(id) ?? false;
  const unsolved = checkbox('Students start from the model as it was opened, unsolved', () => {});
  unsolved.box.checked = true;

  async function forget() {
    dialog.close();
    if ((await actions.edit({ setLesson: { lesson: null } })) !== undefined)
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
      'fieldset',
      element('legend', 'Students may not change'),
      ...locks.map((it) => it.label),
    ),
    unsolved.label,
    element(
      'p.quiet',
      'Students see the text and whether each goal is met while they work. Locked controls are disabled. Undo this step to remove a lock. A constraint with limit 0 must be exact.',
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
  // Enter in a field of a goal must not close the dialog.
  form.addEventListener('submit', (event) => event.preventDefault());
  const dialog = openDialog({ id: 'lesson-dialog', title: 'Lesson' }, form);
  text.focus();
  text.setSelectionRange(0, 0);
  text.scrollTop = 0;
}
