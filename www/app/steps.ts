/**
 * The five steps, one below the other: which of them and of their second levels are open is
 * remembered. Something that needs the user opens its step. In a narrow window the steps are tabs,
 * whose sheet the tab that is pressed again closes.
 */

import { frameOf } from '../store/frame.ts';
import { NEXT_STEP_KEYS, nextStep, type NextStep } from '../store/next-step.ts';
import { sizeOfSelection } from '../store/selection.ts';
import { STEPS, type State, type Step, type Store } from '../store/state.ts';
import { itemByKey } from '../ui/controls/navigation.ts';
import { byId } from '../ui/dom.ts';
import { isEmbedded } from '../ui/embedded.ts';
import { REVEALED } from '../ui/reveal.ts';
import { setItem } from '../ui/safe-storage.ts';
import { narrow } from '../viewport/camera.ts';

/** Storage key of the ids of what is open; `index.html` reads it before the first paint. */
const OPEN = 'shape-up.open';

/** As the style sheets have it: there is room for the model and one card. */
const small = matchMedia('(max-width: 699px), (max-height: 480px)');

const placeOf = (step: Step): HTMLDetailsElement => byId(`step-${step}`);

export function followSteps(store: Store) {
  const panel = byId('steps');
  const levels = [...panel.querySelectorAll<HTMLDetailsElement>('details[id]')];
  const remember = () => {
    // All steps of a narrow window are open, one of them in sight; another page has no tabs.
    if (narrow.matches || isEmbedded) return;
    const open = levels.filter((level) => level.open).map(({ id }) => id);
    setItem(OPEN, JSON.stringify(open));
  };
  const wide = () => STEPS.filter((step) => placeOf(step).open);
  /** Tells which steps are in sight. */
  const tell = () => {
    const { step } = store.get();
    const isTab = narrow.matches && !isEmbedded;
    const inTab = document.body.dataset.sheet === 'open' ? [step] : [];
    store.set({ openSteps: isTab ? inTab : wide() });
  };
  /** Opens a step. That is told at once: the event comes later. */
  const show = (step: Step) => {
    placeOf(step).open = true;
    tell();
  };
  const openAll = () => STEPS.forEach(show);
  // It does not bubble.
  for (const told of [remember, tell]) panel.addEventListener('toggle', told, true);
  /** What was open when the window became narrow. */
  let open = wide();
  const summaries = STEPS.map((step) => placeOf(step).querySelector('summary'));
  const leaveOutOfTabs = () => {
    for (const summary of summaries) if (summary) summary.tabIndex = narrow.matches ? -1 : 0;
  };
  leaveOutOfTabs();
  narrow.addEventListener('change', () => {
    leaveOutOfTabs();
    if (narrow.matches) {
      open = wide();
      openAll();
    } else {
      for (const step of STEPS) placeOf(step).open = open.includes(step);
    }
  });
  if (narrow.matches || isEmbedded) openAll();

  let next: NextStep | null = null;
  /** The model that the user has run: an example that is solved when it opens opens no step. */
  let run: State['model'] = null;
  store.subscribe([...NEXT_STEP_KEYS], (state) => {
    if (state.running) run = state.model;
    if (!state.document || nextStep(state) === next) return;
    next = nextStep(state);
    if (run === state.model) show(next === 'build' ? 'build' : 'shape');
  });
  // A lesson says what to do; the button of its dialog is farther down.
  let hadLesson = false;
  store.subscribe(['document'], ({ document }) => {
    // While a mesh is replaced there is no document, which does not end the lesson.
    if (!document) return;
    const isNew = document.lesson !== null && !hadLesson;
    hadLesson = document.lesson !== null;
    if (!isNew) return;
    show('open');
    panel.scrollTo(0, 0);
  });
  // What can be done with a selection is there.
  let wasEmpty = true;
  store.subscribe(['selection'], ({ selection }) => {
    const isEmpty = sizeOfSelection(selection) === 0;
    if (wasEmpty && !isEmpty) show('move');
    wasEmpty = isEmpty;
  });
  // Something has to be opened.
  store.subscribe(['nothingOpen'], ({ nothingOpen }) => {
    if (nothingOpen) show('open');
  });
  // Opens the step for a mesh with problems, and once for each file whose unit or axis was guessed.
  const asked: WeakSet<object> = new WeakSet();
  store.subscribe(['model'], ({ model }) => {
    if (!model) return;
    const { units, up } = frameOf(store.get()).guessed;
    const asks = (units || up) && !asked.has(model.guessed);
    asked.add(model.guessed);
    if (asks || model.problems.length > 0) show('open');
  });
  tabs(store, panel, tell);
}

/**
 * The tabs of a narrow window.
 * @param tell called when another step is in sight
 */
function tabs(store: Store, panel: HTMLElement, tell: () => void) {
  const { dataset } = document.body;
  const buttons = STEPS.map((step) => byId(`tab-${step}`));
  const show = (step: Step, isOpen: boolean) => {
    dataset.sheet = isOpen ? 'open' : 'closed';
    store.set({ step });
    update();
    measure();
  };
  /** What of the window is left for the view. */
  function measure() {
    const isSheet = narrow.matches && dataset.sheet === 'open';
    store.set({ room: isSheet ? 'sheet' : small.matches ? 'small' : 'wide' });
    tell();
  }
  for (const query of [narrow, small]) query.addEventListener('change', measure);
  measure();
  function update() {
    const { step } = store.get();
    dataset.step = step;
    const isOpen = dataset.sheet === 'open';
    buttons.forEach((button, i) => {
      const isShown = STEPS[i] === step;
      button.setAttribute('aria-selected', String(isShown && isOpen));
      button.tabIndex = isShown ? 0 : -1;
    });
  }
  store.subscribe(['step'], update);
  // What comes of a press for all panels is said in the view.
  store.subscribe(['press'], ({ press, step }) => {
    if (!press?.isUnderWay || !narrow.matches || dataset.sheet !== 'open') return;
    const hadFocus = panel.contains(document.activeElement);
    show(step, false);
    if (hadFocus) byId(`tab-${step}`).focus();
  });
  panel.addEventListener(REVEALED, ({ target }) => {
    const step = STEPS.find((one) => target instanceof Node && placeOf(one).contains(target));
    if (step) show(step, true);
  });
  buttons.forEach((button, i) => {
    const isAgain = () => store.get().step === STEPS[i] && dataset.sheet === 'open';
    button.addEventListener('click', () => show(STEPS[i], !isAgain()));
    button.addEventListener('keydown', (event) => {
      const next = itemByKey(event, buttons, { along: 'x' });
      next?.focus();
      next?.click();
    });
  });
}
