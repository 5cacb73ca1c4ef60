/**
 * The New constraint dialog: kind, selector, parameters and weight. It is docked over the Model
 * panel instead of the view, so that the selection can change while it is open. It offers only what
 * fits the mesh, preselects the usual kind for the selection, and previews the constraints of each
 * choice.
 */

import './add-constraint.css';
import { dialogHead } from '../../ui/controls/dialog.ts';
import { byId, element, setText } from '../../ui/dom.ts';
import { newestOnly } from '../../store/newest-only.ts';
import { count, groupDigits } from '../../ui/format.ts';
import { KindChoices } from '../../ui/kinds/kind-choices.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import type { ElementInfo, KindInfo, Preview, Selector } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/**
 * A selector that is offered. `element` is the element that it enumerates; with `within`, only
 * elements in the selection, and only for kinds meant for that element.
 */
type Place = {
  id: string;
  label: string;
  on: Selector;
  element?: ElementInfo['id'];
  within?: boolean;
};
type Offer = { place: Place; preview: Preview };

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
  /** The kind of these parameters. */
  #parametersOf = '';
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
  /** Offers by kind, without kinds that fit nowhere. */
  #offers: Map<string, Offer[]> = new Map();
  /** Whether the solver has yet to answer the last submission. */
  #isAdding = false;
  /** Previews for the latest selection. */
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
    this.#parametersOf = '';
    this.#allow(false);
    this.#dialog.show();
    // Meanwhile a press closes it.
    void this.#actions.reportErrors(this.#renew().then(() => this.#kinds.focus(this.#kindId)));
  }

  /** All selectors, whether a kind fits them or not. */
  #allPlaces(): Place[] {
    const { elements, selection } = this.#store.get();
    const vertices = this.#actions.selectedVertices();
    const faces = [...selection.faces];
    const places: Place[] = [];
    if (vertices.length > 0) {
      places.push({ id: 'selection', label: 'whole selection together', on: { vertices } });
      const within = faces.length > 0 ? { faces } : { vertices };
      for (const { id, label, faceBased } of elements) {
        const on = { each: id, in: within };
        if (faceBased && faces.length > 0)
          places.push({ id: `each-${id}-selected`, label: `each selected ${label}`, on });
        else
          places.push({
            id: `each-${id}-selected`,
            label: `each ${label}, within the selection`,
            on,
            element: id,
            within: true,
          });
      }
    }
    for (const { id, label } of elements)
      places.push({ id: `each-${id}`, label: `each ${label}`, on: { each: id }, element: id });
    return places;
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

  /** Requests previews from the solver and offers what fits. */
  async #ask() {
    const places = this.#allPlaces();
    const { ask, reportErrors } = this.#actions;
    const previews = await this.#newest(reportErrors(ask.previews(places.map(({ on }) => on))));
    if (!previews) return;
    this.#offers = new Map();
    this.#store.get().kinds.forEach((kind, k) => {
      const offers = places.flatMap((place, p) => {
        const preview = previews[k][p];
        if (!preview || (place.within && !(place.element && kind.elements.includes(place.element))))
          return [];
        return [{ place, preview }];
      });
      if (offers.length > 0) this.#offers.set(kind.id, offers);
    });
    if (!this.#isChosen) this.#suggest(places);
    this.#show();
  }

  /** Preselects the usual kind of the first place that has one. */
  #suggest(places: Place[]) {
    for (const place of places) {
      for (const [kind, offers] of this.#offers) {
        if (!offers.some((one) => one.place === place && one.preview.usual)) continue;
        [this.#kindId, this.#placeId] = [kind, place.id];
        return;
      }
    }
    this.#kindId = '';
    this.#placeId = places[0]?.id ?? '';
  }

  /** Shows the offers and the choices. */
  #show() {
    const offered = this.#store.get().kinds.filter((kind) => this.#offers.has(kind.id));
    const kind = offered.find((one) => one.id === this.#kindId) ?? offered[0];
    this.#kindId = kind?.id ?? '';
    this.#kinds.show(offered, this.#kindId);
    this.#showMisfits();
    setText(this.#about, kind?.summary ?? '');
    this.#showParameters(kind);

    const offers = this.#offers.get(this.#kindId) ?? [];
    if (!offers.some(({ place }) => place.id === this.#placeId)) {
      this.#placeId = offers[0]?.place.id ?? '';
    }
    const focused = document.activeElement?.id;
    this.#places.replaceChildren(...offers.map((one) => this.#placeChoice(one)));
    if (focused) document.getElementById(focused)?.focus();
    // The chosen options are scrolled into view in their lists.
    for (const choice of this.#dialog.querySelectorAll('label:has(:checked)'))
      choice.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    this.#showPreview();
  }

  #showMisfits() {
    const { kinds, elements } = this.#store.get();
    const left = kinds.filter((kind) => !this.#offers.has(kind.id));
    const wants = (kind: KindInfo) => {
      const places = elements.filter(({ id }) => kind.elements.includes(id));
      const where = places.map(({ label }) => label).join(' or ');
      return where ? `it is for each ${where}` : `it takes ${kind.takes}`;
    };
    this.#misfits.hidden = left.length === 0;
    this.#misfits.replaceChildren(
      element('summary', `${count(left.length, 'shape does', 'shapes do')} not fit here`),
      element('ul', ...left.map((kind) => element('li', `${kind.label}: ${wants(kind)}`))),
    );
  }

  #showParameters(kind: KindInfo | undefined) {
    const { model } = this.#store.get();
    if (!model || this.#parametersOf === (kind?.id ?? '')) return;
    this.#parametersOf = kind?.id ?? '';
    this.#parameters = new Parameters(kind?.params ?? [], {}, model);
    this.#parametersPlace.replaceChildren(this.#parameters.element);
    this.#parametersPlace.hidden = !kind?.params.length;
  }

  #placeChoice({ place, preview }: Offer) {
    const amount = `new-place-${place.id}-amount`;
    const radio = element('input', {
      type: 'radio',
      name: 'new-place',
      id: `new-place-${place.id}`,
      'aria-label': place.label,
      'aria-describedby': amount,
      onchange: () => {
        this.#placeId = place.id;
        this.#isChosen = true;
        this.#showPreview();
      },
    });
    radio.checked = place.id === this.#placeId;
    return element(
      'label.choice',
      radio,
      element('span', place.label),
      element('span.amount.figure', { id: amount }, groupDigits(preview.constraints)),
    );
  }

  /** The chosen offer. */
  #chosen() {
    return this.#offers.get(this.#kindId)?.find(({ place }) => place.id === this.#placeId);
  }

  #showPreview() {
    const offer = this.#chosen();
    this.#allow(offer !== undefined);
    if (!offer) return setText(this.#preview, 'No shape fits here.');
    const { constraints, skipped, vertices } = offer.preview;
    const each = vertices / constraints;
    const size = Number.isInteger(each)
      ? count(each, 'vertex', 'vertices')
      : `${each.toFixed(1)} vertices on average`;
    const made = `${count(constraints, 'constraint')} of ${size}.`;
    const left =
      skipped > 0 ? ` ${groupDigits(skipped)} skipped: their number of vertices does not fit.` : '';
    setText(this.#preview, made + left);
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
    if (isOther || !offer || !params || !this.#dialog.open || !this.#weight.reportValidity())
      return;
    const weight = this.#weight.value === '' ? 1 : this.#weight.valueAsNumber;
    const added = await this.#actions.edit(
      { addConstraint: { kind, params, on: offer.place.on, weight } },
      (error) => this.#parameters.refuse(error),
    );
    if (added === undefined) return;
    this.#dialog.close();
    if (runs) this.#actions.run();
    const { label } = this.#store.get().kinds.find(({ id }) => id === kind) ?? {};
    this.#actions.setStatus(`Added ${count(offer.preview.constraints, 'constraint')}: ${label}`);
  }
}
