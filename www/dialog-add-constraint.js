/**
 * Add constraint: a shape, where, and how much. Beside the view and not over it, so that the
 * selection can change while it is open. Only what fits the mesh is offered; what a choice would
 * make is said before it is made.
 */

import { element, icon, setText } from './dom.js';
import { count, groupDigits } from './format.js';

/** @typedef {import("./messages.js").KindInfo} KindInfo */
/** @typedef {import("./messages.js").Selector} Selector */
/** @typedef {import("./messages.js").Replies["preview"]} Preview */
/** @typedef {{ id: string, label: string, on: Selector }} Place */

export class AddConstraintDialog {
  #dialog;
  #store;
  #solver;
  #actions;
  #kinds = element('div', { class: 'choices in-columns' });
  /** What the chosen shape asks. */
  #about = element('p', { class: 'about quiet' });
  #places = element('div', { class: 'choices' });
  #params = element('div', { class: 'weight-row' });
  #preview = element('p', { class: 'preview quiet', 'aria-live': 'polite' });
  #weight = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    value: '1',
    id: 'new-weight',
  });
  #add = element('button', { type: 'submit', class: 'primary' }, 'Add');
  /** The shape and the place that are chosen, while they are offered. */
  #kindId = '';
  #placeId = '';
  /** What the chosen shape would make, by place. @type {Map<string, { place: Place, preview: Preview }>} */
  #offers = new Map();
  /** Answers to an older question are not wanted. */
  #question = 0;

  /**
   * @param {HTMLDialogElement} dialog
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {import("./actions.js").Actions} actions
   */
  constructor(dialog, store, solver, actions) {
    this.#dialog = dialog;
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    const close = () => dialog.close();
    dialog.replaceChildren(
      element(
        'div',
        { class: 'dialog-head' },
        element('h2', { id: 'add-constraint-title' }, 'New constraint'),
        element(
          'button',
          { type: 'button', class: 'square', 'aria-label': 'Close', onclick: close },
          icon('close'),
        ),
      ),
      element(
        'form',
        { onsubmit: (/** @type {SubmitEvent} */ event) => this.#submit(event) },
        element('fieldset', {}, element('legend', {}, 'Shape'), this.#kinds, this.#about),
        element('fieldset', {}, element('legend', {}, 'Where'), this.#places),
        this.#params,
        element(
          'div',
          { class: 'weight-row' },
          element('label', { for: 'new-weight' }, 'Weight'),
          this.#weight,
          element('span', { class: 'quiet' }, 'against the other constraints'),
        ),
        this.#preview,
        element(
          'div',
          { class: 'dialog-foot' },
          element('button', { type: 'button', class: 'bordered', onclick: close }, 'Cancel'),
          this.#add,
        ),
      ),
    );
    dialog.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      close();
    });
    store.subscribe(['selection', 'model'], () => {
      if (dialog.open) this.#ask();
    });
  }

  get isOpen() {
    return this.#dialog.open;
  }

  async open() {
    const { selection } = this.#store.get();
    if (this.#dialog.open) return this.#dialog.close();
    this.#placeId = selection.vertices.size + selection.faces.size > 0 ? 'selection' : '';
    this.#weight.value = '1';
    this.#dialog.show();
    await this.#ask();
    this.#kinds.querySelector('input')?.focus();
  }

  close() {
    this.#dialog.close();
  }

  /** Where a constraint could be, before asking which of it fits. @returns {Place[]} */
  #allPlaces() {
    const { elements, selection } = this.#store.get();
    const places = elements.map(({ id, label }) => ({
      id: `each-${id}`,
      label: `each ${label}`,
      on: { each: id },
    }));
    const vertices = this.#actions.chosenVertices();
    const faces = [...selection.faces];
    if (faces.length > 0) {
      const faceElement = elements.find((one) => one.faceBased);
      if (faceElement) {
        const on = { each: faceElement.id, in: { faces } };
        places.unshift({ id: 'each-selected', label: 'each selected face', on });
      }
    }
    if (vertices.length > 0) {
      places.unshift({ id: 'selection', label: 'the selection as one set', on: { vertices } });
    }
    return places;
  }

  /**
   * What a kind would make at each place where it fits.
   * @param {KindInfo} kind
   * @param {Place[]} places
   */
  async #fitting(kind, places) {
    const answers = await Promise.all(
      places.map(async (place) => {
        const request = { type: /** @type {const} */ ('preview'), kind: kind.id, on: place.on };
        const preview = await this.#solver.request(request).catch(() => null);
        return preview && preview.constraints > 0 ? { place, preview } : null;
      }),
    );
    return answers.filter((answer) => answer !== null);
  }

  /** Asks the solver what fits, and offers that. */
  async #ask() {
    const question = ++this.#question;
    const places = this.#allPlaces();
    const { kinds } = this.#store.get();
    const offers = await Promise.all(kinds.map((kind) => this.#fitting(kind, places)));
    if (question !== this.#question) return;
    const offered = kinds.filter((_, i) => offers[i].length > 0);
    if (!offered.some((kind) => kind.id === this.#kindId)) {
      // The first choice is one for panels, not one that would flatten them to lines.
      this.#kindId = (offered.find((kind) => kind.measure) ?? offered[0])?.id ?? '';
    }
    const chosen = kinds.findIndex((kind) => kind.id === this.#kindId);
    this.#offers = new Map(
      chosen < 0 ? [] : offers[chosen].map((offer) => [offer.place.id, offer]),
    );
    if (!this.#offers.has(this.#placeId)) {
      this.#placeId = this.#offers.keys().next().value ?? '';
    }
    const focused = document.activeElement?.id;
    this.#kinds.replaceChildren(...offered.map((kind) => this.#kindChoice(kind)));
    this.#places.replaceChildren(
      ...[...this.#offers.values()].map((one) => this.#placeChoice(one)),
    );
    this.#about.textContent = kinds[chosen]?.summary ?? '';
    this.#showParams(kinds[chosen]);
    this.#showPreview();
    if (focused) document.getElementById(focused)?.focus();
  }

  /** @param {KindInfo} kind */
  #kindChoice(kind) {
    const radio = element('input', {
      type: 'radio',
      name: 'new-kind',
      id: `new-kind-${kind.id}`,
      'aria-label': kind.label,
      'aria-describedby': `new-kind-${kind.id}-summary`,
      onchange: () => {
        this.#kindId = kind.id;
        this.#ask();
      },
    });
    radio.checked = kind.id === this.#kindId;
    return element(
      'label',
      { class: 'choice' },
      radio,
      element('span', { class: 'chip', style: `--chip: rgb(${kind.colour.join(' ')})` }),
      element('span', {}, kind.label),
      // The one that is chosen is said below the list; a screen reader hears each.
      element(
        'span',
        { class: 'visually-hidden', id: `new-kind-${kind.id}-summary` },
        kind.summary,
      ),
    );
  }

  /** @param {{ place: Place, preview: Preview }} offer */
  #placeChoice({ place, preview }) {
    const radio = element('input', {
      type: 'radio',
      name: 'new-place',
      id: `new-place-${place.id}`,
      onchange: () => {
        this.#placeId = place.id;
        this.#showPreview();
      },
    });
    radio.checked = place.id === this.#placeId;
    return element(
      'label',
      { class: 'choice plain' },
      radio,
      element('span', {}, place.label),
      element('span', { class: 'amount figure' }, groupDigits(preview.constraints)),
    );
  }

  /** @param {KindInfo | undefined} kind */
  #showParams(kind) {
    if (this.#params.dataset.kind === kind?.id) return;
    this.#params.dataset.kind = kind?.id ?? '';
    this.#params.replaceChildren(
      ...(kind?.params ?? []).flatMap((param) => {
        // A range keeps its default.
        if (typeof param.default !== 'number') return [];
        return [
          element(
            'label',
            { for: `new-${param.id}` },
            param.unit ? `${param.label} (${param.unit})` : param.label,
          ),
          element('input', {
            type: 'number',
            step: 'any',
            id: `new-${param.id}`,
            name: param.id,
            min: param.range[0],
            max: param.range[1] ?? '',
            value: param.default,
          }),
        ];
      }),
    );
  }

  #showPreview() {
    const offer = this.#offers.get(this.#placeId);
    this.#add.disabled = !offer;
    if (!offer) return setText(this.#preview, 'No shape fits here.');
    const { constraints, skipped, vertices } = offer.preview;
    const each = vertices / constraints;
    const size = Number.isInteger(each)
      ? count(each, 'vertex', 'vertices')
      : `${each.toFixed(1)} vertices on average`;
    const made = `${count(constraints, 'constraint')} of ${size}.`;
    const left =
      skipped > 0
        ? ` ${groupDigits(skipped)} skipped: their number of vertices does not fit this shape.`
        : '';
    setText(this.#preview, made + left);
  }

  /** @param {SubmitEvent} event */
  async #submit(event) {
    event.preventDefault();
    const offer = this.#offers.get(this.#placeId);
    if (!offer) return;
    /** @type {Record<string, number>} */
    const params = {};
    for (const field of this.#params.querySelectorAll('input'))
      params[field.name] = field.valueAsNumber;
    const added = await this.#actions.edit({
      type: 'addConstraint',
      kind: this.#kindId,
      params,
      on: offer.place.on,
      weight: this.#weight.value === '' ? 1 : this.#weight.valueAsNumber,
    });
    if (added === undefined) return;
    this.#dialog.close();
    const { label } = this.#store.get().kinds.find((kind) => kind.id === this.#kindId) ?? {};
    this.#actions.say(`Added ${count(offer.preview.constraints, 'constraint')}: ${label}`);
  }
}
