/**
 * One press for all panels: the offer over the view for a mesh just opened, the progress, and the
 * verdict. Without the offer, the same buttons are in the Model panel.
 */

import './make-panels.css';
import { button, closeButton } from '../../ui/controls/fields.ts';
import { endOfRun } from '../../store/end-of-run.ts';
import { latestOnly } from '../../store/latest-only.ts';
import { newestOnly } from '../../store/newest-only.ts';
import {
  RENEW_MS,
  byId,
  element,
  removeKeepingFocus,
  setAttribute,
  setText,
  throttled,
} from '../../ui/dom.ts';
import { cover, showElements } from '../../viewport/camera.ts';
import { BetterChoices } from './better-choices.ts';
import { isMeshLocked, panelButtons, addButtons } from './buttons.ts';
import { openNewPanels } from './new-panels.ts';
import { openEdit } from './refine-operation.ts';
import type { BetterPress, KindInfo, PanelStart, PanelVerdict } from '../../solver/types.ts';
import type { MeshSuggestion } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';
import type { State } from '../../store/state.ts';

/** Minimum duration of the transition: a jump would not show what changes. */
const TRANSITION_MS = 800;
const still = matchMedia('(prefers-reduced-motion: reduce)');

export class MakePanels {
  #app;
  #card = byId('make-panels-card');
  #panel = byId('make-panels');
  /** The content of the card. */
  #shows: 'nothing' | 'offer' | 'verdict' = 'nothing';
  /** The model whose offer or verdict the user closed. */
  #closed: unknown = null;
  /** The model whose panels were made one shape. */
  #pressed: unknown = null;
  /** The model in transition. */
  #underWay: unknown = null;
  /** The model for which a press has switched the fitted shapes on. */
  #shown: unknown = null;
  #text = element('span');
  /** Numbers of the verdict, shown where the legend gives way to it. */
  #numbers = element('span.numbers');
  #verdict = element('p', this.#text, ' ', this.#numbers);
  /** How far the mesh will move, and why. */
  #forecast = element('p.quiet.forecast');
  /** Lays out panels along the lines of curvature; not offered where they would help little. */
  #newPanels = button(
    'New panels along the curvature',
    () => this.#app.actions.reportErrors(this.#layOut()),
    { class: 'bordered suggestion' },
  );
  /** The model for which they help. */
  #helped: unknown = null;
  /** The model of the forecast. */
  #forecastOf: unknown = null;
  /** A change of the mesh that would reduce the move. */
  #suggestion: MeshSuggestion | null = null;
  #suggestionButton = button('', () => this.#applySuggestion(), {
    class: 'bordered suggestion',
    'aria-haspopup': 'dialog',
  });
  #showFolds = button('Show the folds', () => this.#app.actions.begin(this.#showFolded()));
  /** Makes the panels again, within another tolerance. */
  #again = button('', () => this.#makeAgain());
  #better: BetterChoices;
  #changes: HTMLElement;
  /** The better choice that was pressed last, and the generation of the shape that it led to. */
  #choice: { label: string; shape?: number } | null = null;
  /** The id of the kind of the verdict. */
  #kind = '';
  #verdicts = latestOnly(() => this.#renewVerdict());
  /** Whether the next verdict is that on an ended run. */
  #isAtEnd = false;
  #newestForecast = newestOnly(() => this.#app.store.get().model);

  constructor(app: AppContext) {
    this.#app = app;
    this.#better = new BetterChoices(
      app,
      (press) => this.#press(press),
      () => this.#showIfAny(),
    );
    const { group } = this.#better;
    this.#changes = element('div.changes', this.#showFolds, this.#again, group);
    addButtons(app, (kind) => this.#make(kind));
    this.#addCommands();
    const { store, solver } = app;
    store.subscribe(['model', 'kinds', 'document', 'example', 'flatMap'], () => this.#show());
    // The next mesh starts without fitted shapes.
    store.subscribe(['model'], ({ model }) => {
      if (!this.#shown || this.#shown === model) return;
      this.#shown = null;
      this.#app.actions.display({ shapes: false });
    });
    let wasRunning = false;
    store.subscribe(['running'], ({ running }) => {
      if (wasRunning && !running && !this.#isUnderWay()) void this.#showVerdict(true);
      wasRunning = running;
    });
    const updateSoon = throttled(RENEW_MS, () => this.#showVerdict(false));
    solver.on('frame', updateSoon);
    store.subscribe(['document'], updateSoon);
    // The card grows when suggestions are added later.
    new ResizeObserver(() => this.#cover()).observe(this.#card);
    // A docked panel hides the card. Noticed here, before the smaller view is framed anew.
    const { body } = document;
    new MutationObserver(() => this.#cover()).observe(body, { attributeFilter: ['data-docked'] });
  }

  /** Adds the commands that make all panels one shape, once the solver has declared the kinds. */
  #addCommands() {
    this.#app.store.subscribe(['kinds'], ({ kinds }) => {
      const own = kinds.filter(({ panels }) => panels !== null);
      const made = own.map((kind) => ({
        id: `make-${kind.id}`,
        group: 'Shape',
        label: `Make panels ${kind.panels}`,
        keys: [],
        needsModel: true,
        enabled: ({ model }: Readonly<State>) =>
          model?.panels.find((one) => one.kind === kind.id)?.reason === null,
        action: () => this.#make(kind),
      }));
      this.#app.commands.push(...made);
    });
  }

  #isUnderWay() {
    return this.#underWay !== null && this.#underWay === this.#app.store.get().model;
  }

  /**
   * Makes all panels of this kind, with a transition.
   * @param from the shape to start from
   * @param within the tolerance, if other than the displayed one
   */
  async #make(kind: KindInfo, from: PanelStart = 'now', within?: number) {
    const { store, solver, viewport, actions, files } = this.#app;
    if (files.openings.coming && !(await this.#nextTakes(kind.id))) return;
    const { model, display } = store.get();
    this.#pressed = this.#underWay = model;
    this.#closed = null;
    const arrived = still.matches ? null : viewport.transition(TRANSITION_MS);
    const show = (shapes: boolean) => actions.display({ shapes });
    // The fitted shapes are those of the final shape.
    if (arrived) show(false);
    const { ended, stop } = endOfRun(solver);
    if ((await actions.makePanels(kind.id, within, from)) === undefined) {
      stop();
      this.#underWay = null;
      viewport.endTransition();
      return show(display.shapes);
    }
    await arrived;
    if (store.get().model !== model) return;
    show(true);
    if (!display.shapes) this.#shown = model;
    await ended;
    if (store.get().model !== model) return;
    this.#underWay = null;
    void this.#showVerdict(true);
  }

  /** Waits for the next model. Returns whether its panels can be this kind. */
  async #nextTakes(id: string) {
    const { store, actions, files } = this.#app;
    const { model: before } = store.get();
    actions.setStatus('Starts when the model is loaded');
    await files.openings.coming;
    const { model } = store.get();
    const offered = model?.panels.find(({ kind }) => kind === id);
    return model !== before && offered !== undefined && !offered.reason;
  }

  #show() {
    const state = this.#app.store.get();
    const { model, document, example, flatMap } = state;
    const rows = document?.constraints.length ?? 0;
    const offers = Boolean(model?.faces && model.panels.length > 0);
    // The legend of a flat map is in the card's position.
    if (!offers || !document || flatMap || this.#closed === model) this.#turnTo('nothing');
    else if (this.#pressed === model && rows > 0) this.#turnTo('verdict');
    else this.#turnTo(rows === 0 && !example ? 'offer' : 'nothing');

    const here = this.#shows === 'offer' ? this.#card : this.#panel;
    const press = (kind: KindInfo) => {
      this.#choice = null;
      return this.#make(kind);
    };
    const change = (operation: string) => this.#change(operation);
    const { buttons, reasons } = panelButtons(state, 'make-panels-reason', press, change);
    this.#panel.hidden = !offers || here !== this.#panel;
    if (here === this.#panel) renew(here, element('div', ...buttons), ...reasons);
    else {
      const others = [...buttons, this.#suggestionButton, this.#somethingElse()];
      if (model?.newPanels) this.#helped = model;
      this.#newPanels.hidden = !this.#newPanelsHelp();
      const press = element('div', this.#newPanels, ...others);
      renew(here, ...reasons, this.#forecast, press, this.#closeButton());
      void this.#showForecast();
    }
    this.#cover();
  }

  /** Opens an operation on the mesh. */
  #change(operation: string) {
    void this.#app.actions.reportErrors(openEdit(this.#app, operation));
  }

  /** Shows how far the mesh will move for the offer; requested once for each model. */
  async #showForecast() {
    const { store, actions } = this.#app;
    const { model } = store.get();
    if (this.#forecastOf === model) return;
    this.#forecastOf = model;
    this.#suggestion = null;
    this.#suggestionButton.hidden = true;
    // It has its place at once: a card that grows moves the model, and what the user does with it.
    this.#forecast.hidden = false;
    setText(this.#forecast, 'Estimating how far the mesh will move …');
    const forecast = await this.#newestForecast(actions.trials.forecast().catch(() => null));
    if (forecast === undefined) return;
    setText(this.#forecast, forecast?.words ?? '');
    this.#forecast.hidden = !forecast;
    this.#suggestion = forecast?.suggestion ?? null;
    if (forecast?.newPanels) this.#helped = model;
    this.#newPanels.hidden = !this.#newPanelsHelp();
    this.#suggestionButton.hidden = !this.#canChangeMesh();
    setText(this.#suggestionButton, this.#suggestion?.label ?? '');
    for (const one of this.#card.querySelectorAll<HTMLElement>('[data-kind]')) {
      one.classList.toggle('recommended', one.dataset.kind === forecast?.recommended);
    }
    this.#cover();
  }

  #newPanelsHelp() {
    const state = this.#app.store.get();
    return this.#helped !== null && this.#helped === state.model && !isMeshLocked(state);
  }

  /** Whether a simple change of this mesh reduces the move, and new panels are not the better choice. */
  #canChangeMesh() {
    const state = this.#app.store.get();
    const isOfModel = this.#suggestion !== null && this.#forecastOf === state.model;
    return isOfModel && !this.#newPanelsHelp() && !isMeshLocked(state);
  }

  /** Opens the card of new panels, on the original shape. */
  async #layOut() {
    const { store, actions } = this.#app;
    if (store.get().document?.constraints.length) await actions.reset();
    openNewPanels(this.#app, (kind) => this.#make(kind));
  }

  /** Opens the operation that reduces the move, on the original shape. */
  async #applySuggestion() {
    const { store, actions } = this.#app;
    if (!this.#suggestion) return;
    if (store.get().document?.constraints.length) await actions.reset();
    this.#change(this.#suggestion.operation);
  }

  #turnTo(what: 'nothing' | 'offer' | 'verdict') {
    if (this.#shows === what) return;
    this.#shows = what;
    const show = () => {
      this.#card.hidden = what === 'nothing';
      this.#card.dataset.shows = what;
      this.#card.classList.remove('warning');
      this.#card.replaceChildren();
    };
    removeKeepingFocus(this.#card, show);
    if (what !== 'verdict') return;
    setText(this.#text, '');
    setText(this.#numbers, '');
    const hold = button('Hold to see the original', () => {});
    this.#app.hold.bind(hold);
    this.#changes.hidden = true;
    this.#changes.append(this.#newPanels, this.#suggestionButton);
    this.#card.append(this.#verdict, hold, this.#closeButton(), this.#changes);
    void this.#showVerdict(false);
  }

  #somethingElse() {
    const onclick = () => byId('add-constraint-button').click();
    return element('button', { 'aria-haspopup': 'dialog', onclick }, 'Something else');
  }

  #closeButton() {
    const close = () => {
      const { model, verdict } = this.#app.store.get();
      this.#closed = model;
      if (verdict) this.#app.actions.judge({ ...verdict, isClosed: true });
      this.#show();
    };
    return closeButton('Close', close);
  }

  /** Shows the verdict, after the end of a run or of a change. */
  async #showVerdict(atEnd: boolean) {
    if (this.#shows !== 'verdict') return;
    this.#isAtEnd ||= atEnd;
    await this.#verdicts.ask();
  }

  async #renewVerdict() {
    const { store, actions } = this.#app;
    const { model } = store.get();
    const goesOn = () => store.get().running || this.#isUnderWay();
    const isShown = () => store.get().model === model && this.#shows === 'verdict';
    if (goesOn()) {
      const progress = await actions.ask.panelProgress().catch(() => '');
      if (!progress || !isShown() || !goesOn()) return;
      setAttribute(this.#verdict, 'aria-live', 'off');
      setText(this.#text, `${store.get().numbers?.attempt ?? ''} ${progress}`.trim());
      setText(this.#numbers, '');
      return this.#showChanges(null);
    }
    const atEnd = this.#isAtEnd;
    this.#isAtEnd = false;
    const verdict = await actions.ask.verdict().catch(() => null);
    // Where a run has begun meanwhile, its progress comes next.
    if (!verdict || !isShown() || goesOn()) return;
    actions.judge({ shape: this.#app.solver.geometry?.generation, report: verdict });
    setAttribute(this.#verdict, 'aria-live', 'polite');
    setText(this.#text, `${this.#chosen(atEnd)}${verdict.brief}`);
    setText(this.#numbers, verdict.numbers);
    this.#kind = verdict.kind;
    this.#showChanges(verdict);
  }

  /** The better choice that led to the shape, to begin a verdict with; empty for another shape. */
  #chosen(atEnd: boolean) {
    const shape = this.#app.solver.geometry?.generation;
    if (this.#choice && atEnd && shape !== undefined) this.#choice.shape ??= shape;
    return this.#choice?.shape === shape && this.#choice ? `${this.#choice.label}: ` : '';
  }

  /** Offers ways to a better shape, if the final `verdict` asks for it. */
  #showChanges(verdict: PanelVerdict | null) {
    this.#card.dataset.level = verdict?.level ?? '';
    const isGood = !verdict || verdict.level === 'good';
    this.#showFolds.hidden = !verdict?.folded;
    const again = verdict?.again ?? null;
    this.#again.hidden = again === null;
    setText(this.#again, again ?? '');
    this.#suggestionButton.hidden = isGood || !this.#canChangeMesh();
    this.#newPanels.hidden = isGood || !this.#newPanelsHelp();
    if (isGood) this.#better.clear();
    else void this.#better.find(verdict);
    this.#showIfAny();
    this.#card.classList.toggle('warning', !isGood);
  }

  #showIfAny() {
    this.#changes.hidden = !this.#changes.querySelector(':scope > :not([hidden])');
    this.#cover();
  }

  /** Makes the panels by a better press. */
  async #press({ kind: id, within, from, label }: BetterPress) {
    const kind = this.#app.store.get().kinds.find((one) => one.id === id);
    if (!kind) return;
    this.#choice = { label };
    await this.#make(kind, from, within);
  }

  /** Selects the folded faces and brings them into view. */
  async #showFolded() {
    const { actions } = this.#app;
    const found = await actions.reportErrors(actions.ask.flawed('folded-faces'));
    if (found) showElements(this.#app, found);
  }

  /** Makes the panels again from the original, within the tolerance that is shown. */
  async #makeAgain() {
    const kind = this.#app.store.get().kinds.find(({ id }) => id === this.#kind);
    this.#choice = null;
    if (kind) await this.#make(kind, 'original');
  }

  /** Frames the model in the area above the card. */
  #cover() {
    const covered = cover(this.#app.viewport, this.#card);
    byId('main').style.setProperty('--covered', `${covered}px`);
  }
}

/** Replaces the content of an element and keeps the focus on the button of the same index. */
function renew(place: HTMLElement, ...content: HTMLElement[]) {
  const at = [...place.querySelectorAll('button')].findIndex(
    (one) => one === document.activeElement,
  );
  place.replaceChildren(...content);
  place.querySelectorAll('button')[at]?.focus();
}
