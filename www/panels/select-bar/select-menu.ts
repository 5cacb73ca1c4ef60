/**
 * The menu of selection operations: the declared operations by group, then sets and groups by name.
 * An operation with parameters replaces the menu by its form.
 */

import { button, closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import { keyName } from '../../ui/keys.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import { combineOf, sizeOfSelection, verticesOf, type Combine } from '../../store/selection.ts';
import type { Operation } from '../../solver/types.ts';
import type { Store } from '../../store/state.ts';
import type { Actions } from '../../store/actions.ts';
import type { Selecting } from '../../store/mesh-queries.ts';

export function fillSelectMenu(
  menu: HTMLElement,
  store: Store,
  actions: Actions,
  selecting: Selecting,
) {
  const state = store.get();
  const { operations, selection, mode } = state;
  const close = () => menu.hidePopover();

  function item(operation: Operation) {
    const asks = operation.params.length > 0;
    const button = element(
      'button',
      {
        title: operation.summary,
        onclick: async (event: MouseEvent) => {
          if (asks) return show(form(operation));
          close();
          await selecting.applyOrReport(operation, { combine: combineWith(operation, event) });
        },
      },
      element('span', asks ? `${operation.label}…` : operation.label),
      ...operation.keys.slice(0, 1).map((key) => element('kbd', keyName(key))),
    );
    button.disabled = !selecting.canApply(operation);
    return button;
  }

  /** Makes the form of an operation. */
  function form(operation: Operation) {
    const parameters = new Parameters(operation.params, {}, store.get().model);
    const find = async (combine: Combine) => {
      const params = parameters.values();
      if (!params) return;
      try {
        const found = await selecting.apply(operation, { params, combine });
        if (found) close();
      } catch (error) {
        if (!parameters.refuse(error)) await actions.reportErrors(Promise.reject(error));
      }
    };
    // The only submit button is Find, so that Enter in a field presses it.
    const submit = (event: SubmitEvent) => {
      event.preventDefault();
      void find('replace');
    };
    return element(
      'form',
      { novalidate: true, onsubmit: submit, 'aria-label': operation.label },
      heading(operation.label),
      element('p.quiet', operation.summary),
      parameters.element,
      element(
        'div.verbs',
        ...(operation.needsSelection
          ? []
          : [button('Subtract', () => find('remove')), button('Add', () => find('add'))]),
        element('button.primary', { type: 'submit' }, 'Find'),
      ),
    );
  }

  /** Lists the sets of the scene and the groups of the file. */
  function named() {
    const operation = operations.find(({ takesName }) => takesName);
    if (!operation) return [];
    const pick = (name: string) => async (event: MouseEvent) => {
      close();
      await selecting.applyOrReport(operation, {
        params: { name },
        combine: combineWith(operation, event),
      });
    };
    const remove = (name: string) => {
      close();
      void actions.edit({ removeSet: { name } });
    };
    const sets = (state.document?.sets ?? []).map(({ name, vertices, faces }) => {
      const size = faces > 0 ? count(faces, 'face') : count(vertices, 'vertex', 'vertices');
      return element(
        'div.set',
        element(
          'button',
          { onclick: pick(name) },
          element('span', name),
          element('span.quiet', size),
        ),
        closeButton(`Remove set ${name}`, () => remove(name), { title: 'Remove' }),
      );
    });
    const groups = (state.model?.groups ?? []).map(({ name, faces }) =>
      element(
        'button',
        { onclick: pick(name) },
        element('span', name),
        element('span.quiet', count(faces, 'face')),
      ),
    );
    const save = element(
      'button',
      { onclick: () => show(saveForm()) },
      element('span', 'Save as a set…'),
    );
    save.disabled = sizeOfSelection(selection) === 0;
    return [heading('Sets and groups'), save, ...sets, ...groups];
  }

  function saveForm() {
    const name = element('input', {
      type: 'text',
      required: true,
      'aria-label': 'Name of the set',
    });
    const submit = async (event: SubmitEvent) => {
      event.preventDefault();
      const words = name.value.trim();
      if (!words) return name.focus();
      close();
      await actions.settled();
      const { vertices, faces, edges } = store.get().selection;
      // Sets have only vertices and faces, so edges are stored by their ends.
      const ends = edgeEnds(edges);
      const edit = {
        nameSet: {
          name: words,
          vertices: [...new Set([...vertices, ...ends])].sort((a, b) => a - b),
          faces: [...faces].sort((a, b) => a - b),
        },
      };
      if ((await actions.edit(edit)) !== undefined) actions.setStatus(`Saved as the set ${words}`);
    };
    return element(
      'form',
      { onsubmit: submit, 'aria-label': 'Save as a set' },
      heading('Save as a set'),
      element(
        'p.quiet',
        'Gives the selection a name, by which you can select or constrain it later.',
      ),
      name,
      element('div.verbs', element('button.primary', { type: 'submit' }, 'Save set')),
    );
  }

  function edgeEnds(edges: ReadonlySet<number>) {
    const connectivity = actions.connectivity();
    if (edges.size === 0 || !connectivity) return [];
    return verticesOf({ vertices: [], edges, faces: [] }, connectivity);
  }

  function show(content: HTMLElement) {
    menu.replaceChildren(content);
    const first: HTMLElement | null = menu.querySelector('input, select, button');
    first?.focus();
  }

  const fitting = operations.filter(({ modes, takesName }) => modes.includes(mode) && !takesName);
  const groups = [...new Set(fitting.map(({ group }) => group))];
  menu.replaceChildren(
    ...groups.flatMap((group) => [
      heading(group),
      ...fitting.filter((operation) => operation.group === group).map(item),
    ]),
    ...named(),
  );
  menu.querySelector('button')?.focus();
}

function heading(text: string) {
  return element('p.heading.quiet', text);
}

/** Operations that start from the selection replace it. */
function combineWith(operation: Operation, event: MouseEvent) {
  return operation.needsSelection ? 'replace' : combineOf(event);
}
