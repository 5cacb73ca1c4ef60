/** The forms that replace the menu of selections: of an operation, and of a new set. */

import { useEffect, useRef } from 'preact/hooks';
import { useSignal } from '@preact/signals';
import { frameOf } from '../../store/frame.ts';
import { shownUnit, toleranceOf } from '../../store/colours/measures.ts';
import { verticesOf, type Combine } from '../../store/selection.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { writtenUnit } from '../../ui/words.ts';
import { useRefusal } from '../../ui/kinds/parameter-refusal.ts';
import { Parameters } from '../../ui/kinds/parameters.tsx';
import type { ComponentChildren } from 'preact';
import type { Operation, Param, ParamValue } from '../../pkg/engine/shape_up.js';

export const Heading = ({ children }: { children: ComponentChildren }) => (
  <p class="heading quiet">{children}</p>
);

/** A form whose first control has the focus at first. */
function useFocusedForm() {
  const form = useRef<HTMLFormElement>(null);
  useEffect(() => form.current?.querySelector<HTMLElement>('input, select, button')?.focus(), []);
  return form;
}

/** The parameters of an operation. */
export function OperationForm(props: { operation: Operation; close: () => void }) {
  const { operation, close } = props;
  const { store, actions, selecting } = useApp();
  const { label } = operation;
  const { state } = store;
  const form = useFocusedForm();
  const { refusal, refuse, forget } = useRefusal(operation.params);
  const entered = useSignal<Record<string, ParamValue>>({});
  const valuesOf = (params: Param[]) => ({
    ...Object.fromEntries(params.map((param) => [param.id, param.default])),
    ...entered.value,
  });
  /** The face measure that is chosen here, if any: its limits begin at its tolerance. */
  const chosen = Object.values(valuesOf(operation.params));
  const measure = state.measures.find(({ id }) => chosen.includes(id));
  const tolerance = measure ? toleranceOf(state, measure) : null;
  const params = operation.params.map((param) =>
    typeof param.default === 'number' ? { ...param, default: tolerance ?? param.default } : param,
  );
  const limit = Number(params.find((param) => typeof param.default === 'number')?.default);
  const { units } = frameOf(state);
  const isColouring = measure !== undefined && measure.id === state.measure;
  const written = isColouring
    ? shownUnit(state)
    : measure && writtenUnit(measure.unit, units, tolerance ?? limit);
  const isLength = measure?.unit === 'length';
  const unit = written && { symbol: written.symbol, factor: written.factor, isLength };

  async function find(combine: Combine) {
    // What is wrong is said at its field.
    if (!form.current?.checkValidity()) return;
    try {
      if (await selecting.apply(operation, { params: valuesOf(params), combine })) close();
    } catch (error) {
      if (!refuse(error)) await actions.reportErrors(Promise.reject(error));
    }
  }

  return (
    <form
      ref={form}
      novalidate
      aria-label={label}
      // The only submit button is Find, so that Enter in a field presses it.
      onSubmit={(event) => {
        event.preventDefault();
        void find('replace');
      }}
    >
      <Heading>{label}</Heading>
      <p class="quiet">{operation.summary}</p>
      <Parameters
        params={params}
        values={entered.value}
        frame={frameOf(state)}
        unit={unit}
        refusal={refusal}
        onValue={(id, value) => {
          forget();
          // What was typed for another measure is not of its unit.
          const isMeasure = state.measures.some((one) => one.id === value);
          entered.value = { ...(!isMeasure && entered.value), [id]: value };
        }}
      />
      <div class="row-buttons">
        {!operation.needsSelection && (
          <>
            <Button onClick={() => find('remove')}>Subtract</Button>
            <Button onClick={() => find('add')}>Add</Button>
          </>
        )}
        <Button type="submit" class="primary">
          Find
        </Button>
      </div>
    </form>
  );
}

/** The name of a set with what is selected. */
export function SaveForm({ close }: { close: () => void }) {
  const { store, actions } = useApp();
  const form = useFocusedForm();
  const name = useRef<HTMLInputElement>(null);

  /** Sets have only vertices and faces, so edges are stored by their ends. */
  function edgeEnds(edges: ReadonlySet<number>) {
    const connectivity = actions.connectivity();
    if (edges.size === 0 || !connectivity) return [];
    return verticesOf({ vertices: [], edges, faces: [] }, connectivity);
  }

  async function save(words: string) {
    await actions.settled();
    const { vertices, faces, edges } = store.get().selection;
    const edit = {
      nameSet: {
        name: words,
        vertices: [...new Set([...vertices, ...edgeEnds(edges)])].sort((a, b) => a - b),
        faces: [...faces].sort((a, b) => a - b),
      },
    };
    if ((await actions.edit(edit)) !== undefined) actions.setStatus(`Saved as the set ${words}`);
  }

  return (
    <form
      ref={form}
      aria-label="Save as a set"
      onSubmit={(event) => {
        event.preventDefault();
        const words = name.current?.value.trim();
        if (!words) return name.current?.focus();
        close();
        void save(words);
      }}
    >
      <Heading>Save as a set</Heading>
      <p class="quiet">
        Gives the selection a name, by which you can select or constrain it later.
      </p>
      <input ref={name} type="text" required aria-label="Name of the set" />
      <div class="row-buttons">
        <Button type="submit" class="primary">
          Save set
        </Button>
      </div>
    </form>
  );
}
