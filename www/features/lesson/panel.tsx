/**
 * The lesson of the scene: its text, its goals with their current values, and the results for
 * hand-in. If its panel is hidden behind a tab, a line over the view shows how many goals are met.
 */

import './lesson.css';
import { createRef, type ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { isInLegend, movedInWords } from '../../store/colours/measures.ts';
import { LOCKED, type Lock } from '../../store/panels-card.ts';
import { showDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button, Icon } from '../../ui/components/buttons.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { reveal } from '../../ui/reveal.ts';
import type { AppContext } from '../../app/context.ts';
import type { LessonWords } from '../../pkg/engine/shape_up.js';

const mark = (isMet: boolean) => (isMet ? '✓' : '✗');

/** The locks in display order. */
export const LOCKS: [Lock, string][] = [
  ['mesh', 'Mesh'],
  ['constraints', 'Constraints'],
  ['weights', 'Weights'],
  ['handles', 'Handles'],
];

/** The lesson, if there is one. */
function useLessonWords() {
  const { state } = useApp().store;
  /** While a mesh is replaced there is no document, which is no reason to remove the lesson. */
  const last = useRef<LessonWords | null>(null);
  if (state.document) last.current = state.document.lesson;
  return last.current;
}

/** The lesson, and how far its goals are met. */
function useLesson() {
  const { state } = useApp().store;
  const lesson = useLessonWords();
  const now = useThrottled(() => state.numbers?.lesson ?? null);
  return { lesson, now: now?.goals.length === lesson?.goals.length ? now : null };
}

/** The lesson in its step, to which the line over the view leads. */
const place = createRef<HTMLElement>();

export function Lesson() {
  const app = useApp();
  const { state } = app.store;
  const { lesson, now } = useLesson();
  const moved = useThrottled(() => (state.document?.lesson ? movedInWords(state) : ''));
  if (!lesson) return null;
  const locked = LOCKS.filter(([id]) => lesson.lock.includes(id));
  const passed = now?.passed ?? false;
  return (
    <section ref={place} id="lesson" aria-labelledby="heading-lesson">
      <h2 id="heading-lesson">Lesson</h2>
      <p class="lesson-text">{lesson.text}</p>
      <ul aria-label="Goals">
        {lesson.goals.map((goal, i) => {
          const { met, words, value: measured } = now?.goals[i] ?? {};
          const value = (goal.build !== null && state.goalsRefused) || measured;
          // A goal on a constraint has the value of its row.
          const isInRow = goal.measure === null && goal.build === null;
          const isMeasured = goal.beyond === null && isInLegend(state, goal.measure);
          const elsewhere = isInRow ? 'in-rows' : isMeasured ? 'in-legend' : undefined;
          return (
            <li
              key={i}
              class={met === undefined ? undefined : met ? 'goal-met' : 'goal-missed'}
              title={`The ${goal.words}`}
            >
              <span class="mark" aria-hidden="true">
                {met !== undefined && mark(met)}
              </span>
              <span>{goal.sentence}</span>
              <span class="now">
                {words}
                {value && <span class={elsewhere}>: {value}</span>}
              </span>
            </li>
          );
        })}
      </ul>
      {locked.length > 0 && (
        <p class="quiet">Locked: {locked.map(([, label]) => label.toLowerCase()).join(', ')}</p>
      )}
      <p class={passed ? 'lesson-sum passed' : 'lesson-sum'} aria-live="polite">
        {passed && `${mark(true)} `}
        {now?.words}
      </p>
      {moved && <p class="quiet in-legend">Moved {moved}</p>}
      <Button aria-haspopup="dialog" onClick={() => showHandIn(app)}>
        Results for hand-in
      </Button>
    </section>
  );
}

/** The line over the view, which leads to the goals. */
export function LessonCard() {
  const { lesson, now } = useLesson();
  return (
    <div
      id="lesson-card"
      class={now?.passed ? 'passed' : undefined}
      aria-live="polite"
      hidden={!lesson}
    >
      <button
        type="button"
        class="card"
        title="Show the goals"
        onClick={() => place.current && reveal(place.current)}
      >
        <span>{now ? `${mark(now.passed)} Lesson: ${now.words}` : 'Goals'}</span>
        <Icon name="chevron" />
      </button>
    </div>
  );
}

/**
 * A part of the page that a lesson may lock: its controls are disabled then. The session also refuses
 * such edits.
 * @param words what stays as it is, if that is said above the part
 */
export function Lockable({
  lock,
  words,
  children,
}: {
  lock: Lock;
  words?: string;
  children: ComponentChildren;
}) {
  const isLocked = useLessonWords()?.lock.includes(lock) ?? false;
  const note = isLocked && words ? `${lock}-locked` : undefined;
  return (
    <>
      {note && (
        <p class="locked-note quiet" id={note}>
          {LOCKED}: {words}.
        </p>
      )}
      <fieldset
        class="locked"
        disabled={isLocked}
        role={isLocked ? undefined : 'presentation'}
        title={isLocked ? LOCKED : undefined}
        aria-describedby={note}
      >
        {children}
      </fieldset>
    </>
  );
}

/** Opens the dialog that saves a student's results for hand-in. */
function showHandIn(app: AppContext) {
  showDialog(app, { id: 'hand-in', title: 'Results for hand-in' }, HandIn);
}

function HandIn() {
  const { store, files, actions } = useApp();
  const name = useRef<HTMLInputElement>(null);
  const goals = useThrottled(() => store.state.numbers?.lesson?.goals ?? []);
  const met = goals.filter((goal) => goal.met).length;

  async function save() {
    const student = name.current?.value.trim() ?? '';
    const time = new Date().toISOString();
    const make = () => actions.ask.results(student, time);
    await actions.reportErrors(files.save('.results.json', 'application/json', make));
  }

  return (
    <form class="dialog-body" method="dialog" onSubmit={save}>
      <label class="line">
        Your name
        <input
          ref={name}
          autofocus
          type="text"
          id="student"
          autocomplete="name"
          maxLength={120}
          required
        />
      </label>
      <p>
        {`${met} of ${goals.length} goals are satisfied now. The file contains the shape, the goals with their values, the steps in Undo, and the time.`}
      </p>
      <p class="quiet">
        The file is saved only on this computer: send it in as you send other work. The recipient
        can measure the shape again.
      </p>
      <div class="dialog-buttons">
        <Button type="submit" class="primary">
          Save the file
        </Button>
      </div>
    </form>
  );
}
