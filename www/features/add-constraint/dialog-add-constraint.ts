/**
 * The New constraint dialog: kind, selector, parameters and weight. It is docked over the Model
 * panel instead of the view, so that the selection can change while it is open. The solver says what
 * fits the mesh, which kind and place to start with, and how many constraints each choice makes.
 */

import './add-constraint.css';
import { dialogHead } from '../../ui/controls/dialog.ts';
import { byId, element, setText } from '../../ui/dom.ts';
import { newestOnly } from '../../store/newest-only.ts';
import { count, groupDigits } from '../../ui/format.ts';
import { KindChoices } from '../../ui/kinds/kind-choices.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import type { ConstraintOffers, KindInfo, Loaded } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

type Offer = ConstraintOffers['kinds'][number]['offers'][number];

/** Before the solver has answered. */
const NOTHING: ConstraintOffers = { places: [], kinds: [], start: null, misfit: '', misfits: [] };

let dialog: AddConstraintDialog | undefined;

/** Opens the dialog, or closes it when it is open. */
export function toggleAddConstraint(app: AppContext) {
  dialog ??= new AddConstraintDialog(byId('add-constraint'), app);
  dialog.toggle();
}

class AddConstraintDialog {
  #dialog;
  #store;
  #actions;
  #kinds = new KindChoices((kind) => {
    this.#kindId = kind.id;
    this.#isChosen = true;
    this.#show();
  });
  /** The kinds that fit nowhere, and why. */
  #misfits = element('details.misfits.quiet', { hidden: true });
  /** What the chosen kind requires. */
  #about = element('p.about.quiet');
  #places = element('div.choices');
  #parameters = new Parameters([], {}, { units: '', meanEdge: 0, up: 'z' });
  #parametersPlace = element('div');
  /** The kind of these parameters, and the model, whose unit and edges they have. */
  #parametersOf: { kind: string; model: Loaded | null } = { kind: '', model: null };
  #preview = element('p.preview.quiet', { 'aria-live': 'polite' });
  #weight = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    value: '1',
    id: 'new-weight',
  });
  #addAndRun = element('button.primary', { type: 'submit' }, 'Add and run');
  #add = element('button.bordered', { type: 'submit' }, 'Add');
  /** Ids of the chosen kind and place, while they are offered. */
  #kindId = '';
  #placeId = '';
  /** Whether the user made a choice, which a new selection must not change. */
  #isChosen = false;
  #offers = NOTHING;
  /** Whether the solver has yet to answer the last submission. */
  #isAdding = false;
  /** Offers for the latest selection. */
  #newest = newestOnly();
  /** Resolves when the offers for the latest selection are shown. */
  #asking: Promise<void> = Promise.resolve();

  constructor(dialog: HTMLDialogElement, { store, actions }: AppContext) {
    this.#dialog = dialog;
    this.#store = store;
    this.#actions = actions;
    dialog.replaceChildren(
      dialogHead(dialog, 'add-constraint-title', 'New constraint'),
      element(
        'form',
        // Invalid values are reported at their fields.
        { novalidate: true, onsubmit: (event: SubmitEvent) => this.#submit(event) },
        element(
          'div.shape',
          element('fieldset', element('legend', 'Shape'), this.#kinds.element, this.#misfits),
          this.#about,
          this.#parametersPlace,
        ),
        element('fieldset', element('legend', 'Where'), this.#places),
        element(
          'div.weight-row',
          element('label', { for: 'new-weight' }, 'Weight'),
          this.#weight,
          element('span.quiet', 'against the other constraints'),
        ),
        element('div.dialog-foot', this.#preview, this.#add, this.#addAndRun),
      ),
    );
    dialog.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      dialog.close();
    });
    store.subscribe(['selection', 'model'], () => {
      if (dialog.open) void this.#renew();
    });
  }

  toggle() {
    if (this.#dialog.open) return this.#dialog.close();
    this.#isChosen = false;
    this.#weight.value = '1';
    this.#parametersOf = { kind: '', model: null };
    this.#allow(false);
    this.#dialog.show();
    // Meanwhile a press closes it.
    void this.#actions.reportErrors(this.#renew().then(() => this.#kinds.focus(this.#kindId)));
  }

  #renew() {
    return (this.#asking = this.#ask());
  }

  /** Resolves when what is offered fits the selections begun before. */
  async #upToDate() {
    await this.#actions.settled();
    let asking;
    while (asking !== this.#asking) {
      asking = this.#asking;
      await asking;
    }
  }

  /** Requests from the solver what fits, and offers it. */
  async #ask() {
    const { ask, reportErrors, selectedVertices } = this.#actions;
    const vertices = Uint32Array.from(selectedVertices());
    const faces = Uint32Array.from(this.#store.get().selection.faces);
    const offers = await this.#newest(reportErrors(ask.constraintOffers(vertices, faces)));
    if (!offers) return;
    this.#offers = offers;
    if (!this.#isChosen) {
      this.#kindId = offers.start?.kind ?? '';
      this.#placeId = offers.start?.place ?? '';
    }
    this.#show();
  }

  /** What is offered for a kind. */
  #offersOf(id: string): Offer[] {
    return this.#offers.kinds.find(({ kind }) => kind === id)?.offers ?? [];
  }

  /** Shows the offers and the choices. */
  #show() {
    const offered = this.#store.get().kinds.filter(({ id }) => this.#offersOf(id).length > 0);
    const kind = offered.find((one) => one.id === this.#kindId) ?? offered[0];
    this.#kindId = kind?.id ?? '';
    this.#kinds.show(offered, this.#kindId);
    this.#showMisfits();
    setText(this.#about, kind?.summary ?? '');
    this.#showParameters(kind);

    const offers = this.#offersOf(this.#kindId);
    if (!offers.some(({ place }) => place === this.#placeId))
      this.#placeId = offers[0]?.place ?? '';
    const focused = document.activeElement?.id;
    this.#places.replaceChildren(...offers.map((one) => this.#placeChoice(one)));
    if (focused) document.getElementById(focused)?.focus();
    // The chosen options are scrolled into view in their lists.
    for (const choice of this.#dialog.querySelectorAll('label:has(:checked)'))
      choice.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    this.#showPreview();
  }

  #showMisfits() {
    const { misfit, misfits } = this.#offers;
    this.#misfits.hidden = misfits.length === 0;
    this.#misfits.replaceChildren(
      element('summary', misfit),
      element('ul', ...misfits.map((words) => element('li', words))),
    );
  }

  #showParameters(kind: KindInfo | undefined) {
    const { model } = this.#store.get();
    const now = { kind: kind?.id ?? '', model };
    const before = this.#parametersOf;
    if (!model || (before.kind === now.kind && before.model === model)) return;
    this.#parametersOf = now;
    this.#parameters = new Parameters(kind?.params ?? [], {}, model);
    this.#parametersPlace.replaceChildren(this.#parameters.element);
    this.#parametersPlace.hidden = !kind?.params.length;
  }

  #placeOf(offer: Offer) {
    return this.#offers.places.find(({ id }) => id === offer.place);
  }

  #placeChoice(offer: Offer) {
    const id = `new-place-${offer.place}`;
    const amount = `${id}-amount`;
    const label = this.#placeOf(offer)?.label ?? '';
    const radio = element('input', {
      ...{ type: 'radio', name: 'new-place', id },
      'aria-label': label,
      'aria-describedby': amount,
      onchange: () => {
        this.#placeId = offer.place;
        this.#isChosen = true;
        this.#showPreview();
      },
    });
    radio.checked = offer.place === this.#placeId;
    return element(
      'label.choice',
      radio,
      element('span', label),
      element('span.amount.figure', { id: amount }, groupDigits(offer.constraints)),
    );
  }

  /** The chosen offer. */
  #chosen() {
    return this.#offersOf(this.#kindId).find(({ place }) => place === this.#placeId);
  }

  #showPreview() {
    const offer = this.#chosen();
    this.#allow(offer !== undefined);
    setText(this.#preview, offer?.words ?? 'No shape fits here.');
  }

  /** @param isPossible whether the choice can be added */
  #allow(isPossible: boolean) {
    this.#add.disabled = !isPossible;
    this.#addAndRun.disabled = !isPossible;
  }

  async #submit(event: SubmitEvent) {
    event.preventDefault();
    if (this.#isAdding) return;
    this.#isAdding = true;
    await this.#addChosen(event.submitter === this.#addAndRun);
    this.#isAdding = false;
  }

  /** Adds what is chosen, to the selection as it is at the press. */
  async #addChosen(runs: boolean) {
    const chosen = [this.#kindId, this.#placeId];
    await this.#upToDate();
    const kind = this.#kindId;
    // What the user chose may not fit the new selection: the other offer is shown first.
    const isOther = this.#isChosen && (kind !== chosen[0] || this.#placeId !== chosen[1]);
    const offer = this.#chosen();
    const params = this.#parameters.values();
    const place = offer && this.#placeOf(offer);
    if (isOther || !place || !params || !this.#dialog.open || !this.#weight.reportValidity())
      return;
    const weight = this.#weight.value === '' ? 1 : this.#weight.valueAsNumber;
    const added = await this.#actions.edit(
      { addConstraint: { kind, params, on: place.on, weight } },
      (error) => this.#parameters.refuse(error),
    );
    if (added === undefined) return;
    this.#dialog.close();
    if (runs) this.#actions.run();
    const { label } = this.#store.get().kinds.find(({ id }) => id === kind) ?? {};
    this.#actions.setStatus(`Added ${count(offer.constraints, 'constraint')}: ${label}`);
  }
}
