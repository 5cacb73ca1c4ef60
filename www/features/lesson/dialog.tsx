/** The dialog for writing a lesson: its text, goals and locks, and its export for a class. */

import './lesson.css';
import { useRef, useState } from 'preact/hooks';
import { withoutPath } from '../../store/actions.ts';
import { declared, toleranceOf } from '../../store/colours/measures.ts';
import { performNamed } from '../../store/perform.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { sceneOf } from '../../solver/scene-text.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { NumberInput, numberIn } from '../../ui/components/number-input.tsx';
import { count, measured, rounded, writtenUnit } from '../../ui/words.ts';
import { LOCKS } from './panel.tsx';
import type { AppContext } from '../../app/context.ts';
import type {
  GoalFile,
  FaceMeasure,
  Document as SceneDocument,
} from '../../pkg/engine/shape_up.js';
import type { State } from '../../store/state.ts';

/** What a goal can be about. */
interface Subject {
  value: string;
  label: string;
  unit: string;
  /** of a length, in which it can also be typed; empty otherwise */
  typed: string;
  /** whether a number of things is bounded, not the largest value */
  isCount: boolean;
  /** from the unit of the goal in the file */
  factor: number;
  goal: GoalFile;
}

type BuildNumbers = Awaited<ReturnType<AppContext['actions']['ask']['buildNumbers']>>;

export async function write(app: AppContext) {
  const { store, actions } = app;
  const { document: scene, model } = store.get();
  if (!scene) return;
  const numbers = model?.faces ? await actions.ask.buildNumbers() : [];
  const subjects = subjectsOf(store.get(), scene, numbers);
  showDialog(app, { id: 'lesson-dialog', title: 'Lesson' }, ({ close }) => (
    <LessonDialog close={close} scene={scene} subjects={subjects} />
  ));
}

/** What the goals of a lesson can be about, those of the present lesson included. */
function subjectsOf(state: Readonly<State>, scene: SceneDocument, numbers: BuildNumbers) {
  const { tolerance, units, lesson } = scene;
  // Goals are written in the unit of the tolerance.
  const { symbol, factor } = writtenUnit('length', units, tolerance);
  const lengths = { unit: symbol || 'unit of the mesh', typed: symbol, factor };
  const ofUnit = (unit: FaceMeasure['unit']) => {
    if (unit === 'length') return lengths;
    const { symbol, factor } = writtenUnit(unit, units, 1);
    return { unit: symbol, typed: '', factor };
  };
  const isAsked = (id: string) => lesson?.goals.some(({ measure }) => measure === id);
  // Signed measures are not errors, but a file may have a goal on one.
  const measures = state.model?.faces
    ? state.measures.filter(({ signed, id }) => !signed || isAsked(id))
    : [];
  /** The goal that counts faces beyond a value. */
  function counting(measure: string, beyond: number) {
    const { label = measure, unit = 'length' } = declared(state, measure) ?? {};
    return {
      value: `beyond ${beyond} ${measure}`,
      label: `Panels beyond ${measured(beyond, unit, units)}: ${label}`,
      unit: 'panels',
      typed: '',
      isCount: true,
      factor: 1,
      goal: { measure, beyond },
    };
  }
  const all: Subject[] = [
    ...measures.map((measure) => ({
      value: `measure ${measure.id}`,
      label: measure.label,
      ...ofUnit(measure.unit),
      isCount: false,
      goal: { measure: measure.id },
    })),
    ...measures.filter(({ toleranced }) => toleranced).map(({ id }) => counting(id, tolerance)),
    ...scene.constraints.map(({ label }) => ({
      value: `constraint ${label}`,
      label: `Constraint: ${label}`,
      ...lengths,
      isCount: false,
      goal: { constraint: label },
    })),
    ...numbers.map(({ id, label, unit }) => ({
      value: `build ${id}`,
      label: `Build: ${label}`,
      ...ofUnit(unit === 'count' ? 'number' : unit),
      isCount: unit === 'count',
      goal: { build: id },
    })),
    ...(lesson?.goals ?? []).flatMap(({ measure, beyond }) =>
      measure && beyond !== null ? [counting(measure, beyond)] : [],
    ),
  ];
  return [...new Map(all.map((one) => [one.value, one])).values()];
}

/** A goal in the dialog. */
interface Goal {
  id: number;
  subject: Subject;
  /** in the field of the limit, before the user writes another one */
  limit: string;
  /** whether it was just added */
  isNew?: boolean;
}

/** The goals of the present lesson, or one to begin with, if anything can be a goal. */
function firstGoals(state: Readonly<State>, scene: SceneDocument, subjects: Subject[]): Goal[] {
  if (subjects.length === 0) return [];
  const goal = (id: number, about: string, atMost: number | null) => {
    const subject = subjects.find(({ value }) => value === about) ?? subjects[0];
    const limit = atMost === null ? '' : String(rounded(atMost * subject.factor, 12));
    return { id, subject, limit };
  };
  const goals = scene.lesson?.goals ?? [];
  const asked = declared(state, state.measure ?? scene.measure);
  if (goals.length === 0)
    return [goal(0, `measure ${asked?.id}`, asked ? toleranceOf(state, asked) : null)];
  return goals.map(({ measure, build, label, atMost, beyond }, id) => {
    const counted = beyond === null ? `measure ${measure}` : `beyond ${beyond} ${measure}`;
    const other = build ? `build ${build}` : `constraint ${label}`;
    return goal(id, measure ? counted : other, atMost);
  });
}

/** Gives the focus to the first control of a row that was just added. */
const focusRow = (row: HTMLElement | null) => row?.querySelector('select')?.focus();

/** What the limit of a goal may be. */
const limitOf = ({ isCount, typed }: Subject) => ({ min: 0, isWhole: isCount, unit: typed });
const ERROR_AT = /^lesson\.goals\[(\d+)\]/;

function LessonDialog({
  close,
  scene,
  subjects,
}: InDialog & { scene: SceneDocument; subjects: Subject[] }) {
  const app = useApp();
  const { store, files, actions } = app;
  const [goals, setGoals] = useState(() => firstGoals(store.get(), scene, subjects));
  const [refusal, setRefusal] = useState('');
  // Kept shapes, and the start of a lesson that came with one, are not to be lost unasked.
  const kept = scene.variants.length;
  const startsMoved = scene.lesson && files.original && sceneOf(files.original).current;
  const form = useRef<HTMLFormElement>(null);
  const text = useRef<HTMLTextAreaElement>(null);
  const add = useRef<HTMLButtonElement>(null);

  function addGoal() {
    const id = 1 + Math.max(-1, ...goals.map((goal) => goal.id));
    const coloured = `measure ${store.get().measure ?? scene.measure}`;
    const subject = subjects.find(({ value }) => value === coloured) ?? subjects[0];
    setGoals([...goals, { id, subject, limit: '', isNew: true }]);
  }
  function remove({ id }: Goal) {
    setGoals(goals.filter((goal) => goal.id !== id));
    add.current?.focus();
  }

  /** Saves the lesson in one undo step, then calls `then`. */
  async function keep(then?: () => unknown) {
    if (!form.current?.reportValidity()) return;
    const entered = new FormData(form.current);
    const fields = [...form.current.querySelectorAll<HTMLInputElement>('[name="at-most"]')];
    const limits = fields.map((field, i) => numberIn(field, limitOf(goals[i].subject)) ?? 0);
    const lesson = {
      text: text.current?.value.trim() ?? '',
      goals: goals.map(({ subject: { goal, factor } }, i) => ({
        ...goal,
        at_most: limits[i] / factor,
      })),
      lock: LOCKS.map(([id]) => id).filter((id) => entered.has(`lock ${id}`)),
    };
    const unsolved = entered.has('unsolved');
    const kept = await actions.edit({ setLesson: { lesson, unsolved } }, (refused) => {
      const path = refused instanceof Error && 'path' in refused ? String(refused.path) : '';
      setRefusal(withoutPath(refused));
      fields[Number(ERROR_AT.exec(path)?.[1])]?.focus();
      return true;
    });
    if (kept === undefined) return;
    close();
    actions.setStatus('Lesson saved in the scene');
    then?.();
  }

  async function forget() {
    close();
    if ((await actions.edit({ setLesson: { lesson: null } })) !== undefined)
      actions.setStatus('Lesson removed');
  }

  return (
    // Enter in a field of a goal must not close the dialog.
    <form ref={form} class="dialog-body" onSubmit={(event) => event.preventDefault()}>
      <label for="lesson-words">Task</label>
      <textarea
        ref={text}
        autofocus
        id="lesson-words"
        rows={5}
        required
        defaultValue={scene.lesson?.text ?? ''}
      />
      <h3>Goals</h3>
      <ul aria-label="Goals of the lesson">
        {goals.map((goal, i) => {
          const { value, label, unit, isCount } = goal.subject;
          const what = `Goal ${i + 1}: ${label.toLowerCase()}`;
          return (
            <li key={goal.id} ref={goal.isNew ? focusRow : null}>
              {!isCount && 'largest'}
              <Choice
                aria-label={`Goal ${i + 1}: about`}
                value={value}
                options={subjects.map((one) => [one.value, one.label] as const)}
                onChoose={(chosen) => {
                  const subject = subjects.find((one) => one.value === chosen);
                  if (subject) setGoals(goals.with(i, { ...goal, subject }));
                }}
              />
              at most
              <NumberInput
                accepted={limitOf(goal.subject)}
                name="at-most"
                required
                aria-label={`${what} at most${unit && `, ${unit}`}`}
                defaultValue={goal.limit}
              />
              <span class="unit">{unit}</span>
              <CloseButton label={`Remove ${what}`} onClick={() => remove(goal)} />
            </li>
          );
        })}
      </ul>
      <div>
        <button
          ref={add}
          type="button"
          class="bordered"
          disabled={subjects.length === 0}
          onClick={addGoal}
        >
          Add goal
        </button>
      </div>
      <fieldset>
        <legend>Students may not change</legend>
        {LOCKS.map(([id, label]) => (
          <label key={id}>
            <input
              type="checkbox"
              name={`lock ${id}`}
              defaultChecked={scene.lesson?.lock.includes(id) ?? false}
            />
            {label}
          </label>
        ))}
      </fieldset>
      <label>
        <input type="checkbox" name="unsolved" defaultChecked={kept === 0 && !startsMoved} />
        Students start from the original, unsolved
        {kept > 0 && `; ${count(kept, 'kept shape is', 'kept shapes are')} removed`}
      </label>
      <p class="quiet">
        Students see the text and whether each goal is satisfied while they work. Locked controls
        are disabled. Undo unlocks them in this browser, but not in the file or the link. A
        constraint with limit 0 must be exact.{' '}
        <a href="./teaching.html" target="_blank">
          How to make, hand out and mark a lesson
        </a>
      </p>
      <p class="refused" aria-live="assertive">
        {refusal}
      </p>
      <div class="dialog-buttons">
        <Button class="primary" onClick={() => keep()}>
          Save lesson
        </Button>
        <Button onClick={() => keep(() => files.saveScene())}>Lesson as a scene file</Button>
        <Button onClick={() => keep(() => performNamed('share', app))}>Lesson as a link</Button>
        {scene.lesson && (
          <Button
            disabled={scene.lesson.lock.length > 0}
            title={
              scene.lesson.lock.length > 0
                ? 'A lesson with locks stays. If you have just written it, press Undo.'
                : undefined
            }
            onClick={forget}
          >
            Remove lesson
          </Button>
        )}
      </div>
    </form>
  );
}
