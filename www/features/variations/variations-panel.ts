/**
 * The docked panel of variations, which keep the shape exact, and of the kept shapes, and the button
 * that opens it.
 */

import './variations.css';
import { docked } from '../../docked/docked.ts';
import { button, closeButton } from '../../ui/controls/fields.ts';
import { messageOf } from '../../solver/errors.ts';
import { isHard } from '../../store/state.ts';
import { byId, element, setText } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { latestOnly } from '../../store/latest-only.ts';
import { keptStrip } from './kept-strip.ts';
import { variationCard } from './variation-card.ts';
import type { AppContext } from '../../app/context.ts';

const NONE = 'The shape is not exact: there is nothing to vary.';
const HINT = 'Move the sliders; their effects add up. The line under each shows how far it can go.';

const thePanel = once(variationsPanel);

/** Adds the button. */
export function offerVariations(app: AppContext) {
  const open = button('Variations', () => thePanel(app).toggle());
  byId('move-tools').prepend(open);
  const { store } = app;
  store.subscribe(['document', 'numbers', 'running'], ({ document: scene, numbers, running }) => {
    open.hidden = !scene?.constraints.some(isHard) && !scene?.variants.length;
    open.disabled = running || !(numbers?.exact?.met || scene?.variants.length);
    open.title = open.disabled
      ? 'Available once the exact constraints are met'
      : 'Other shapes that are as exact as this one';
  });
}

function variationsPanel(app: AppContext) {
  const { store, solver, actions } = app;
  const { jobs } = app;
  const { ask } = jobs;
  const { variations } = actions;
  let cards: ReturnType<typeof variationCard>[] = [];
  /** Number of the current search; a new number ends it. */
  let search = 0;
  /** What the latest deed shows: the shape of the sliders, that made exact, or the shape before. */
  let wanted: 'moved' | 'exact' | 'none' = 'none';
  /** The document and theme for which the variations were computed. */
  let searched: unknown[] = [];
  /** The generation of the shape that is varied, and of the worker that has its variations. */
  let varied = { generation: 0, worker: 0 };

  const words = element('p', { 'aria-live': 'polite' });
  const grid = element('div.variation-cards');
  const back = button('Back', leave, { title: 'Moves all sliders to the middle', disabled: true });
  const keep = button('Keep', keepIt, {
    class: 'primary',
    title: 'Makes this the design',
    disabled: true,
  });
  const kept = keptStrip(app);
  const panel = element(
    'section.docked',
    { id: 'variations-panel', 'aria-labelledby': 'heading-variations', hidden: true },
    element(
      'div.heading-row',
      element('h2', { id: 'heading-variations' }, 'Variations'),
      words,
      back,
      keep,
      closeButton('Close variations', () => place.close()),
    ),
    element('div.docked-columns.variation-columns', grid, kept.place),
  );

  /** Computes the variations of the open shape. */
  async function find() {
    const mine = ++search;
    try {
      await findIn(mine);
    } catch (error) {
      if (mine === search) setText(words, messageOf(error));
    }
  }

  /** @param mine the number of the search */
  async function findIn(mine: number) {
    const { connectivity } = solver.geometry ?? {};
    cards = [];
    grid.replaceChildren();
    setText(words, 'Looking for variations of the shape …');
    searched = [store.get().document, store.get().dark];
    await variations.leave();
    const model = await actions.atRest();
    // A run has begun meanwhile: its end begins another search.
    if (!model) return;
    if (!connectivity || !(await jobs.copy(model).findVariations())) {
      if (mine === search) setText(words, NONE);
      return;
    }
    if (mine !== search) return;
    varied = { generation: model.generation, worker: jobs.generation };
    let progress = await ask.advanceVariations();
    while (mine === search && progress.found === null) progress = await ask.advanceVariations();
    if (mine !== search) return;
    const shape = solver.geometry?.positions.slice() ?? new Float64Array(0);
    for (let index = 0; index < (progress.found ?? 0); index++) {
      const displacement = await ask.variation(index);
      if (mine !== search) return;
      const card = variationCard(index, progress.slide, change, release);
      cards.push(card);
      grid.append(card.place);
      card.draw(connectivity, shape, displacement, store.get().document?.up ?? 'z');
    }
    setText(words, cards.length > 0 ? HINT : 'The shape cannot change and stay exact.');
    while (mine === search) {
      cards.forEach((card, k) => card.showRange(progress.ranges[k]));
      if (!progress.more) break;
      // Slider moves take priority.
      while (updates.isBusy() && mine === search)
        await new Promise((resolve) => setTimeout(resolve, 50));
      if (mine === search) progress = await ask.advanceVariations();
    }
  }

  /** Shows what is wanted. */
  function follow(): Promise<unknown> {
    if (wanted === 'none') return variations.leave();
    // The worker that had the variations was ended.
    if (varied.worker !== jobs.generation) return find();
    return wanted === 'exact' ? project() : show();
  }
  const updates = latestOnly(() => actions.reportErrors(follow()));
  const coefficients = () => Float64Array.from(cards, (card) => card.value());
  const isMoved = () => cards.some((card) => card.value() !== 0);

  /** While a slider moves: shows the deformed shape. */
  function change() {
    wanted = 'moved';
    update();
  }

  /** After a slider is released: makes the shape exact. */
  function release() {
    wanted = 'exact';
    update();
  }

  /** Shows the shape of the sliders; during an update, once more after it. */
  function update() {
    keep.disabled = true;
    back.disabled = !isMoved();
    void updates.ask();
  }

  async function show() {
    await variations.show(varied.generation, await ask.towards(coefficients()), null);
  }

  async function project() {
    const asked = coefficients();
    const { positions, part, report } = await ask.go(asked);
    if (!(await variations.show(varied.generation, positions, report)) || updates.hasNext()) return;
    if (part < 1) cards.forEach((card, k) => card.set(part * asked[k]));
    setText(words, part < 1 ? 'This is as far as the shape can go and stay exact.' : HINT);
    back.disabled = keep.disabled = !isMoved();
  }

  async function keepIt() {
    keep.disabled = true;
    const done = await variations.keep();
    if (done) actions.setStatus('Kept: this is the design now');
    else keep.disabled = !isMoved();
  }

  /** Returns to the shape without variation. */
  function leave() {
    cards.forEach((card) => card.set(0));
    back.disabled = keep.disabled = true;
    wanted = 'none';
    void updates.ask();
  }

  const place = docked(panel, {
    opened() {
      void kept.update();
      void find();
      keep.focus();
    },
    closed() {
      search++;
      if (isMoved()) leave();
    },
  });

  store.subscribe(
    ['document', 'running', 'model', 'dark'],
    ({ document: scene, running, model, dark }) => {
      if (panel.hidden) return;
      if (!model?.faces || !scene) return place.close();
      void kept.update();
      // An edit or undo step may have changed the shape, and with it the variations.
      if (!running && (scene !== searched[0] || dark !== searched[1])) void find();
    },
  );
  return place;
}
