/**
 * The New constraint dialog: kind, selector, parameters and weight. It is docked over the steps
 * instead of the view, so that the selection can change while it is open. The solver says what
 * fits the mesh, which kind and place to start with, and how many constraints each choice makes.
 */

import './add-constraint.css';
import { render } from 'preact';
import { useRef } from 'preact/hooks';
import { useSignal } from '@preact/signals';
import { frameOf } from '../../store/frame.ts';
import { AppProvider, useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { NumberInput, numberIn } from '../../ui/components/number-input.tsx';
import { useInSight } from '../../ui/components/use-in-sight.ts';
import { byId } from '../../ui/dom.ts';
import { count, groupDigits } from '../../ui/words.ts';
import { once } from '../../ui/once.ts';
import { useRefusal } from '../../ui/kinds/parameter-refusal.ts';
import { Parameters } from '../../ui/kinds/parameters.tsx';
import { KindChoices } from './kind-choices.tsx';
import { useOffers } from './use-offers.ts';
import type { ParamValue } from '../../pkg/engine/shape_up.js';
import type { Loaded } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** What a weight may be. */
const WEIGHT = { min: 0 };

/** The dialog, which is empty while it is closed. */
const theDialog = once(() => {
  const dialog: HTMLDialogElement = byId('add-constraint');
  dialog.addEventListener('close', () => {
    // It may be open again by now.
    if (!dialog.open) render(null, dialog);
  });
  dialog.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    dialog.close();
  });
  return dialog;
});

/** Opens the dialog. If it is open, it gets the focus and keeps what was chosen. */
export function openAddConstraint(app: AppContext) {
  const dialog = theDialog();
  if (dialog.open)
    return dialog.querySelector<HTMLElement>('form input:checked, form button')?.focus();
  // What was chosen the last time is not meant now.
  render(null, dialog);
  render(
    <AppProvider value={app}>
      <NewConstraint close={() => dialog.close()} />
    </AppProvider>,
    dialog,
  );
  dialog.show();
}

/** Parameters that were entered, for a kind and a model, whose unit and edges they have. */
type Entered = { kind: string; model: Loaded | null; values: Record<string, ParamValue> };

function NewConstraint({ close }: { close: () => void }) {
  const { store, actions } = useApp();
  const { model } = store.state;
  const { offers, upToDate } = useOffers();
  /** What the user chose, which a new selection does not change while it is offered. */
  const choice = useSignal<{ kind: string; place: string } | null>(null);
  const entered = useSignal<Entered>({ kind: '', model: null, values: {} });
  const form = useRef<HTMLFormElement>(null);
  const weight = useRef<HTMLInputElement>(null);
  /** Whether the solver has yet to answer the last submission. */
  const isAdding = useRef(false);

  /** What is chosen among what is offered now. */
  function chosen() {
    const { kind: id = '', place: at = '' } = choice.value ?? offers.value?.start ?? {};
    const offersOf = (one: string) =>
      offers.value?.kinds.find(({ kind }) => kind === one)?.offers ?? [];
    const kinds = store.state.kinds.filter((one) => offersOf(one.id).length > 0);
    const kind = kinds.find((one) => one.id === id) ?? kinds[0];
    const places = offersOf(kind?.id ?? '');
    const offer = places.find(({ place }) => place === at) ?? places[0];
    return { kinds, kind, places, offer };
  }

  const { kinds, kind, places, offer } = chosen();
  const { refusal, refuse, forget } = useRefusal(kind?.params ?? []);
  const placeOf = (id: string) => offers.value?.places.find((one) => one.id === id);
  const valuesOf = (id: string) => {
    const { kind: ofKind, model: ofModel, values } = entered.value;
    return ofKind === id && ofModel === store.state.model ? values : {};
  };
  const { misfit = '', misfits = [] } = offers.value ?? {};

  /** Adds what is chosen, to the selection as it is at the press. */
  async function add(runs: boolean) {
    const before = chosen();
    await upToDate();
    const { kind, offer } = chosen();
    // What the user chose may not fit the new selection: the other offer is shown first.
    const isOther = kind !== before.kind || offer?.place !== before.offer?.place;
    const place = offer && placeOf(offer.place);
    if ((choice.value && isOther) || !kind || !place) return;
    // Invalid parameters are reported at their fields. Without the form, the dialog was closed.
    if (!weight.current?.reportValidity() || !form.current?.checkValidity()) return;
    const defaults = Object.fromEntries(kind.params.map((param) => [param.id, param.default]));
    const params = { ...defaults, ...valuesOf(kind.id) };
    const entered = numberIn(weight.current, WEIGHT);
    const added = await actions.edit(
      {
        addConstraint: {
          ...{ kind: kind.id, params, on: place.on, set: place.set },
          weight: entered ?? 1,
        },
      },
      refuse,
    );
    if (added === undefined) return;
    close();
    if (runs) actions.run();
    actions.setStatus(`Added ${count(offer.constraints, 'constraint')}: ${kind.label}`);
  }

  async function submit(event: SubmitEvent) {
    event.preventDefault();
    if (isAdding.current) return;
    isAdding.current = true;
    const by = event.submitter;
    await add(by instanceof HTMLButtonElement && by.value === 'run');
    isAdding.current = false;
  }

  return (
    <>
      <div class="dialog-head">
        <h2 id="add-constraint-title">New constraint</h2>
        <CloseButton class="square" label="Close" onClick={close} />
      </div>
      <form ref={form} novalidate onSubmit={submit}>
        <div class="shape">
          <fieldset>
            <legend>Shape</legend>
            {offers.value && (
              <KindChoices
                kinds={kinds}
                chosen={kind?.id ?? ''}
                onChoose={(id) => {
                  choice.value = { kind: id, place: offer?.place ?? '' };
                  forget();
                }}
              />
            )}
            {/* The kinds that fit nowhere, and why. */}
            <details class="misfits quiet" hidden={misfits.length === 0}>
              <summary>{misfit}</summary>
              <ul>
                {misfits.map((words) => (
                  <li key={words}>{words}</li>
                ))}
              </ul>
            </details>
          </fieldset>
          <p class="about quiet">{kind?.summary}</p>
          {kind && kind.params.length > 0 && (
            <div>
              <Parameters
                key={kind.id}
                params={kind.params}
                values={valuesOf(kind.id)}
                frame={frameOf(store.state)}
                refusal={refusal}
                onValue={(id, value) => {
                  forget();
                  const values = { ...valuesOf(kind.id), [id]: value };
                  entered.value = { kind: kind.id, model, values };
                }}
              />
            </div>
          )}
        </div>
        <fieldset>
          <legend>Where</legend>
          <div class="choices">
            {places.map(({ place, constraints }) => (
              <Place
                key={place}
                id={place}
                label={placeOf(place)?.label ?? ''}
                amount={groupDigits(constraints)}
                isChosen={place === offer?.place}
                choose={() => {
                  choice.value = { kind: kind?.id ?? '', place };
                }}
              />
            ))}
          </div>
        </fieldset>
        <div class="weight-row">
          <label for="new-weight">Weight</label>
          <NumberInput field={weight} accepted={WEIGHT} defaultValue="1" id="new-weight" />
          <span class="quiet">against the other constraints</span>
        </div>
        <div class="dialog-foot">
          <p class="preview quiet" aria-live="polite">
            {offers.value && (offer?.words ?? 'No shape fits here.')}
          </p>
          <Button type="submit" disabled={!offer}>
            Add
          </Button>
          <Button type="submit" class="primary" value="run" disabled={!offer}>
            Add and run
          </Button>
        </div>
      </form>
    </>
  );
}

function Place(props: {
  id: string;
  label: string;
  /** the number of constraints there */
  amount: string;
  isChosen: boolean;
  choose: () => void;
}) {
  const { label, amount, isChosen, choose } = props;
  const place = useInSight<HTMLLabelElement>(isChosen);
  const id = `new-place-${props.id}`;
  return (
    <label ref={place} class="choice">
      <input
        type="radio"
        name="new-place"
        id={id}
        aria-label={label}
        aria-describedby={`${id}-amount`}
        checked={isChosen}
        onChange={choose}
      />
      <span>{label}</span>
      <span class="amount figure" id={`${id}-amount`}>
        {amount}
      </span>
    </label>
  );
}
