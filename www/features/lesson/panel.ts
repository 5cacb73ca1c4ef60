/**
 * The lesson of the scene: its text, its goals with their current values, and the results for
 * hand-in. If its panel is hidden behind a tab, a line over the view shows how many goals are met.
 */

import './lesson.css';
import { movedInWords } from '../../store/colours/measures.ts';
import { openDialog } from '../../ui/controls/dialog.ts';
import { RENEW_MS, byId, element, icon, setText, throttled } from '../../ui/dom.ts';
import { reveal } from '../../ui/reveal.ts';
import type { AppContext } from '../../app/context.ts';
import type { LessonWords } from '../../solver/types.ts';

const MARKS = { met: '✓', missed: '✗' };

/** Adds the panel and the line, which are hidden while the scene has no lesson. */
export function lessonPanel(app: AppContext) {
  const { store } = app;
  const text = element('p.lesson-text');
  const list = element('ul', { 'aria-label': 'Goals' });
  const locked = element('p.quiet');
  let showLocks: ReturnType<typeof lockedPlaces> | null = null;
  const sum = element('p.lesson-sum', { 'aria-live': 'polite' });
  const cost = element('p.quiet');
  const place = element(
    'section',
    { id: 'lesson', 'aria-labelledby': 'heading-lesson', hidden: true },
    element('h2', { id: 'heading-lesson' }, 'Lesson'),
    text,
    list,
    locked,
    sum,
    cost,
    element(
      'button.bordered',
      { 'aria-haspopup': 'dialog', onclick: () => handIn(app) },
      'Results for hand-in',
    ),
  );
  byId('step-open').querySelector('summary')?.after(place);
  const line = element('span', 'Goals');
  const card = element(
    'div',
    { id: 'lesson-card', 'aria-live': 'polite', hidden: true },
    element('button.card', { title: 'Show the goals', onclick: showGoals }, line, icon('chevron')),
  );
  byId('messages').before(card);
  let rows: { mark: HTMLElement; value: HTMLElement; row: HTMLElement }[] = [];
  let shown = '';

  /** The panel is hidden while the card is shown. */
  function showGoals() {
    reveal(place);
  }

  const showNumbers = throttled(RENEW_MS, () => {
    const { numbers } = store.get();
    const lesson = numbers?.lesson;
    if (!lesson || lesson.goals.length !== rows.length) return;
    lesson.goals.forEach(({ met, words }, index) => {
      const { mark, value, row } = rows[index];
      row.className = met ? 'goal-met' : 'goal-missed';
      setText(mark, met ? MARKS.met : MARKS.missed);
      setText(value, words);
    });
    const { passed, words } = lesson;
    sum.classList.toggle('passed', passed);
    card.classList.toggle('passed', passed);
    setText(sum, passed ? `${MARKS.met} ${words}` : words);
    const moved = movedInWords(store.get());
    setText(cost, moved && `Moved ${moved}`);
    setText(line, `${passed ? MARKS.met : MARKS.missed} Lesson: ${words}`);
  });

  store.subscribe(['document'], ({ document }) => {
    const lesson = document?.lesson ?? null;
    const isNew = lesson && place.hidden;
    if (document) place.hidden = card.hidden = !lesson;
    // Its step may be closed, and the button of the lesson dialog is farther down.
    if (isNew) {
      byId<HTMLDetailsElement>('step-open').open = true;
      byId('steps').scrollTo(0, 0);
    }
    const lock = lesson?.lock ?? [];
    if (document && (lock.length > 0 || showLocks)) (showLocks ??= lockedPlaces())(lock);
    setText(locked, lock.length > 0 ? `Locked: ${locksInWords(lock)}` : '');
    const now = JSON.stringify(lesson);
    if (!lesson || now === shown) return;
    shown = now;
    setText(text, lesson.text);
    rows = lesson.goals.map((goal) => {
      const mark = element('span.mark', { 'aria-hidden': 'true' });
      const value = element('span.now');
      const row = element(
        'li',
        { title: `The ${goal.words}` },
        mark,
        element('span', goal.sentence),
        value,
      );
      return { mark, value, row };
    });
    list.replaceChildren(...rows.map(({ row }) => row));
    showNumbers();
  });
  store.subscribe(['numbers'], showNumbers);
}

/** Opens the dialog that saves a student's results for hand-in. */
function handIn({ store, files, actions }: AppContext) {
  const name = element('input', {
    type: 'text',
    id: 'student',
    autocomplete: 'name',
    maxlength: '120',
    required: true,
  });
  const goals = store.get().numbers?.lesson?.goals ?? [];
  const met = goals.filter((goal) => goal.met).length;
  const form = element(
    'form.dialog-body',
    { method: 'dialog', onsubmit: save },
    element('label.line', 'Your name', name),
    element(
      'p',
      `${met} of ${goals.length} goals are met now. The file contains the shape, the goals with their values, each step that you made, and the time.`,
    ),
    element(
      'p.quiet',
      'The file is saved only on this computer: send it in as you send other work. The recipient can measure the shape again.',
    ),
    element('div.dialog-buttons', element('button.primary', { type: 'submit' }, 'Save the file')),
  );
  openDialog({ id: 'hand-in', title: 'Results for hand-in' }, form);
  name.focus();

  async function save() {
    const student = name.value.trim();
    const time = new Date().toISOString();
    const text = await actions.reportErrors(actions.ask.results(student, time));
    if (text) files.save('.results.json', text, 'application/json');
  }
}

type Lock = LessonWords['lock'][number];

/** Lockable parts of the page. */
const PLACES: { lock: Lock; id: string; words: string }[] = [
  { lock: 'mesh', id: 'model', words: 'the mesh stays as it is' },
  { lock: 'weights', id: 'energies', words: 'the weights stay as they are' },
  { lock: 'constraints', id: 'add-constraint-button', words: '' },
  { lock: 'constraints', id: 'constraints', words: 'the constraints stay as they are' },
  { lock: 'constraints', id: 'make-panels-place', words: '' },
  { lock: 'constraints', id: 'panels-card-place', words: '' },
  { lock: 'handles', id: 'handles', words: 'the handles stay as they are' },
];

/** The locks in display order. */
export const LOCKS: [Lock, string][] = [
  ['mesh', 'Mesh'],
  ['constraints', 'Constraints'],
  ['weights', 'Weights'],
  ['handles', 'Handles'],
];

const locksInWords = (lock: readonly Lock[]) =>
  LOCKS.filter(([id]) => lock.includes(id))
    .map(([, label]) => label.toLowerCase())
    .join(', ');

/**
 * Returns a function that disables what a lesson locks, and shows the reason. The session also refuses
 * such edits.
 */
function lockedPlaces() {
  const places = PLACES.map(({ lock, id, words }) => {
    const place = byId(id);
    const note = element('p.locked-note.quiet', { id: `${id}-locked`, hidden: true });
    note.textContent = words && `Locked by the lesson: ${words}.`;
    // A fieldset also disables controls that are added later.
    const set = element('fieldset.locked', words && { 'aria-describedby': note.id });
    place.before(...(words ? [note, set] : [set]));
    set.append(place);
    return { lock, note, set };
  });
  return (locked: readonly Lock[]) => {
    for (const { lock, note, set } of places) {
      set.disabled = locked.includes(lock);
      set.title = set.disabled ? 'Locked by the lesson' : '';
      note.hidden = !set.disabled || !note.textContent;
    }
  };
}
