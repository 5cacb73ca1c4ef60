/**
 * One press for all panels: what a mesh that was just opened is offered over the view, the way there,
 * and the verdict. The same buttons are in the panel of the model once the offer is gone, so that each
 * is on the page once.
 */

import './make-panels.css';
import { button, closeButton } from '../../ui/controls/fields.js';
import { RENEW_MS, byId, element, leave, setText, throttled } from '../../ui/dom.js';
import { cover } from '../../viewport/covered.js';
import { showElements } from '../../viewport/reveal-elements.js';
import { panelButtons } from './buttons.js';
import { addButtons } from './refine-buttons.js';
import { progressWords, verdictWords } from './verdict.js';

/** @typedef {import("../../solver/messages.js").KindInfo} KindInfo */

/** So long the mesh is on its way at least: a jump would not show what becomes of it. */
const TRANSITION_MS = 800;
const still = matchMedia('(prefers-reduced-motion: reduce)');

export class MakePanels {
  #app;
  #card = byId('make-panels-card');
  #panel = byId('make-panels');
  /** What the card is about. @type {"nothing" | "offer" | "verdict"} */
  #shows = 'nothing';
  /** The model whose offer or verdict was closed. @type {unknown} */
  #closed = null;
  /** The model whose panels were made something. @type {unknown} */
  #pressed = null;
  /** The model that is on its way there. @type {unknown} */
  #underWay = null;
  /** Fitted shapes are shown since a press, whose model it was. @type {unknown} */
  #shown = null;
  #text = element('p');
  /** How far the mesh will move, and why. */
  #forecast = element('p.quiet');
  /** The model that the forecast is of. @type {unknown} */
  #foreseen = null;
  #folds = element(
    'div.folds',
    button('Show the folds', () => this.#showFolded()),
    button('Avoid them', () => this.#avoidFolds(), {
      title: 'Makes the panels anew from the original, smoother or within a larger tolerance',
    }),
  );
  /** The id of the kind that the verdict is about. */
  #kind = '';
  /** A verdict is asked for. */
  #isBusy = false;

  /** @param {import("../../app/context.js").AppContext} app */
  constructor(app) {
    this.#app = app;
    addButtons(app);
    const { store, solver } = app;
    store.subscribe(['model', 'kinds', 'document', 'example'], () => this.#show());
    store.subscribe(['split', 'flatMap'], () => this.#show());
    // The next mesh starts as the first one did.
    store.subscribe(['model'], ({ model }) => {
      if (!this.#shown || this.#shown === model) return;
      this.#shown = null;
      this.#app.actions.display({ shapes: false });
    });
    let wasRunning = false;
    store.subscribe(['running'], ({ running }) => {
      if (wasRunning && !running && !this.#isUnderWay()) this.#showVerdict(true);
      wasRunning = running;
    });
    const updateSoon = throttled(RENEW_MS, () => this.#showVerdict(false));
    solver.on('frame', updateSoon);
    store.subscribe(['tolerance'], updateSoon);
    // What would help comes into it later.
    new ResizeObserver(() => this.#cover()).observe(this.#card);
    // A panel below hides it: that is known before the view, which is smaller then, is framed anew.
    const { body } = document;
    new MutationObserver(() => this.#cover()).observe(body, { attributeFilter: ['data-docked'] });
  }

  #isUnderWay() {
    return this.#underWay !== null && this.#underWay === this.#app.store.get().model;
  }

  /**
   * Makes all panels of this kind, visibly.
   * @param {KindInfo} kind
   * @param {boolean} [afresh] from the original
   */
  async #make(kind, afresh = false) {
    const { store, viewport, actions, files } = this.#app;
    if (files.coming && !(await this.#nextTakes(kind.id))) return;
    const { model, display } = store.get();
    this.#pressed = this.#underWay = model;
    this.#closed = null;
    const arrived = still.matches ? null : viewport.transition(TRANSITION_MS);
    const show = (/** @type {boolean} */ shapes) => actions.display({ shapes });
    // They are those of the shape at the end of the way.
    if (arrived) show(false);
    if ((await actions.makePanels(kind.id, undefined, afresh)) === undefined) {
      this.#underWay = null;
      viewport.endTransition();
      return show(display.shapes);
    }
    const ended = this.#endOfRun();
    await arrived;
    if (store.get().model !== model) return;
    show(true);
    if (!display.shapes) this.#shown = model;
    await ended;
    if (store.get().model !== model) return;
    this.#underWay = null;
    this.#showVerdict(true);
  }

  /** Waits for the model that is on its way; whether it has come, and its panels can be that. @param {string} id */
  async #nextTakes(id) {
    const { store, actions, files } = this.#app;
    const { model: before } = store.get();
    actions.setStatus('Starts when the model is here');
    await files.coming?.catch(() => {});
    const { model } = store.get();
    const offered = model?.panels.find(({ kind }) => kind === id);
    return model !== before && offered !== undefined && !offered.reason;
  }

  /** Settles when the run that goes on has ended. */
  #endOfRun() {
    const { store, solver } = this.#app;
    return new Promise((ended) => {
      let began = store.get().running;
      const stop = solver.on('activity', ({ running }) => {
        began ||= running;
        if (running || !began) return;
        stop();
        ended(undefined);
      });
    });
  }

  #show() {
    const state = this.#app.store.get();
    const { model, document, example, split, flatMap } = state;
    // Two pictures, and a map beside the model, have legends of their own in its place.
    const hasRoom = !split && !flatMap;
    const rows = document?.constraints.length ?? 0;
    const offers = Boolean(model?.faces && model.panels.length > 0);
    if (!offers || !document || !hasRoom || this.#closed === model) this.#turnTo('nothing');
    else if (this.#pressed === model && rows > 0) this.#turnTo('verdict');
    else this.#turnTo(rows === 0 && !example ? 'offer' : 'nothing');

    const here = this.#shows === 'offer' ? this.#card : this.#panel;
    const press = (/** @type {KindInfo} */ kind) => this.#make(kind);
    const { buttons, reasons } = panelButtons(state, 'make-panels-reason', press);
    this.#panel.hidden = !offers || here !== this.#panel;
    if (here === this.#panel) renew(here, element('div', ...buttons), ...reasons);
    else {
      const press = element('div', ...buttons, this.#somethingElse());
      renew(here, ...reasons, this.#forecast, press, this.#cross());
      this.#foresee();
    }
    this.#cover();
  }

  /** Says how far the mesh will move for what is offered; asked once for each. */
  async #foresee() {
    const { store, actions } = this.#app;
    const { model } = store.get();
    if (this.#foreseen === model) return;
    this.#foreseen = model;
    this.#forecast.hidden = true;
    const words = await actions.forecast().catch(() => null);
    if (store.get().model !== model) return;
    setText(this.#forecast, words ?? '');
    this.#forecast.hidden = !words;
  }

  /** @param {"nothing" | "offer" | "verdict"} what */
  #turnTo(what) {
    if (this.#shows === what) return;
    this.#shows = what;
    const show = () => {
      this.#card.hidden = what === 'nothing';
      this.#card.dataset.shows = what;
      this.#card.classList.remove('warning');
      this.#card.replaceChildren();
    };
    leave(this.#card, show);
    if (what !== 'verdict') return;
    setText(this.#text, '');
    const hold = button('Hold to see the original', () => {});
    this.#app.hold.bind(hold);
    this.#folds.hidden = true;
    this.#card.append(this.#text, hold, this.#cross(), this.#folds);
    this.#showVerdict(false);
  }

  #somethingElse() {
    const onclick = () => byId('add-constraint-button').click();
    return element('button', { 'aria-haspopup': 'dialog', onclick }, 'Something else');
  }

  #cross() {
    const close = () => {
      this.#closed = this.#app.store.get().model;
      this.#show();
    };
    return closeButton('Close', close);
  }

  /** Says how it stands; and that it has ended. @param {boolean} atEnd */
  async #showVerdict(atEnd) {
    if (this.#shows !== 'verdict' || (this.#isBusy && !atEnd)) return;
    const { store, actions } = this.#app;
    const { model, document } = store.get();
    const tolerance = store.get().tolerance ?? model?.tolerance ?? 0;
    this.#isBusy = true;
    const verdict = await actions.verdict(tolerance).catch(() => null);
    this.#isBusy = false;
    const { running, numbers } = store.get();
    if (!verdict || store.get().model !== model || this.#shows !== 'verdict') return;
    const words = running || this.#isUnderWay() ? progressWords : verdictWords;
    const text = words(verdict, document?.units ?? '');
    setText(this.#text, text);
    this.#kind = verdict.kind;
    const isFolded = words === verdictWords && verdict.folded > 0;
    this.#card.classList.toggle('warning', isFolded);
    this.#folds.hidden = !isFolded;
    if (atEnd && !running && !numbers?.collapse) actions.setStatus(text);
  }

  /** Selects the faces that are folded, and shows where they are. */
  async #showFolded() {
    const { actions } = this.#app;
    const found = await actions.reportErrors(actions.flawed('folded-faces'));
    if (found) showElements(this.#app, found);
  }

  /** Makes the panels again, from the original: a press looks for a shape that does not fold. */
  async #avoidFolds() {
    const kind = this.#app.store.get().kinds.find(({ id }) => id === this.#kind);
    if (kind) await this.#make(kind, true);
  }

  /** What is framed is seen whole above the card. */
  #cover() {
    const covered = cover(this.#app.viewport, this.#card);
    byId('main').style.setProperty('--covered', `${covered}px`);
  }
}

/**
 * Gives a place its content, and the focus that was in it to the same button.
 * @param {HTMLElement} place
 * @param {...HTMLElement} content
 */
function renew(place, ...content) {
  const at = [...place.querySelectorAll('button')].findIndex(
    (one) => one === document.activeElement,
  );
  place.replaceChildren(...content);
  place.querySelectorAll('button')[at]?.focus();
}
