/** The handles: their number, and buttons and fields for the selected ones. */

import './handles.css';
import { messageOf } from '../solver/errors.ts';
import { areHandlesLocked, draggableInWords, handlesNow } from '../store/handles.ts';
import { sizeOfSelection } from '../store/selection.ts';
import { element, RENEW_MS, setText, throttled } from '../ui/dom.ts';
import { count, coordinate, decimalsFor, readLength } from '../ui/format.ts';
import type { AppContext } from '../app/context.ts';
import type { SceneDocument, Handle } from '../solver/types.ts';
import type { Actions } from '../store/actions.ts';
import type { Store } from '../store/state.ts';

export function handlesPanel(place: HTMLElement, { store, actions }: AppContext) {
  const summary = element('p.quiet');
  const button = (label: string, title: string, onclick: () => unknown) =>
    element('button', { title, onclick }, label);
  const add = button('Make handle', 'Turn the selected vertices into handles (H)', () =>
    actions.holdSelected(false),
  );
  const fix = button('Fix', 'Fix the selected vertices where they are', () =>
    actions.holdSelected(true),
  );
  const remove = button('Remove', 'Remove the selected handles (Shift+H)', () =>
    actions.releaseSelected(),
  );
  const row = element('div.handles-row', add, fix, remove);
  place.replaceChildren(summary, row, handleDetails(store, actions));

  store.subscribe(['document', 'selection'], ({ document, selection }) => {
    const handles = document?.handles ?? [];
    const chosen = sizeOfSelection(selection) > 0;
    summary.textContent = document ? wordsFor(document) : '';
    const pinned = document?.pinned.length ?? 0;
    // Without constraints nothing moves, so pinned vertices do not matter.
    if (pinned > 0 && document?.constraints.length) {
      summary.textContent += ` ${count(pinned, 'vertex is', 'vertices are')} fixed automatically, because nothing else holds that part. Add a handle to hold it where you want.`;
    }
    add.disabled = fix.disabled = !chosen;
    const vertices = new Set(actions.selectedVertices());
    remove.disabled = !handles.some(({ vertex }) => vertices.has(vertex));
    row.hidden = !chosen;
  });
}

/** Says how many handles there are, and what to do with them. */
function wordsFor(scene: SceneDocument) {
  const all = scene.handles.length;
  const isLocked = areHandlesLocked(scene);
  if (all === 0)
    return isLocked
      ? 'No handles.'
      : 'No handles yet. Double-click a vertex to make one, then drag it.';
  const fixed = scene.handles.filter((handle) => handle.fixed).length;
  const share = fixed === all ? ', fixed' : fixed > 0 ? `, ${fixed} of them fixed` : '';
  const one = draggableInWords(scene);
  return `${count(all, 'handle')}${share}.${one && ` Drag ${one} in the view.`}`;
}

/** The length of the simulated drag by which the mesh follows a typed target, in milliseconds. */
const FOLLOW_MS = 300;
const AXES = ['x', 'y', 'z'];
const MIXED = 'mixed';
/** Longer numbers are placed one below the other. */
const MOST_BESIDE = 8;

/** The fields for the selected handles: target, kind and weight. */
function handleDetails(store: Store, actions: Actions) {
  let chosen: Handle[] = [];
  /** Targets not yet in the document, by vertex. */
  const ahead: Map<number, Handle['target']> = new Map();
  /** Ends the current simulated drag. */
  let pending: (() => void) | null = null;
  const vertices = (which: (handle: Handle) => boolean = () => true) =>
    chosen.filter(which).map(({ vertex }) => vertex);

  /** Moves all selected handles along one axis, as one step of undo. */
  function move(axis: number) {
    const field = targets[axis];
    if (field.value.trim() === '') return discardInput(field);
    let entry: ReturnType<typeof readLength>;
    try {
      entry = readLength(field.value, store.get().document?.units ?? '');
    } catch (problem) {
      field.setAttribute('aria-invalid', 'true');
      return setText(error, messageOf(problem));
    }
    const before = chosen;
    pending?.();
    for (const { vertex, target } of before) {
      const to = [...target] as Handle['target'];
      to[axis] = entry.by ? to[axis] + entry.length : entry.length;
      ahead.set(vertex, to);
    }
    typed.delete(field);
    show();
    const after = chosen;
    actions.moveHandles(before, 'start');
    actions.moveHandles(after, 'move');
    const timer = setTimeout(() => pending?.(), FOLLOW_MS);
    pending = () => {
      clearTimeout(timer);
      pending = null;
      actions.moveHandles(after, 'end');
    };
    actions.setStatus(
      after.length === 1 ? 'Handle moved' : `${count(after.length, 'handle')} moved`,
    );
  }

  const title = element('p.quiet');
  const error = element('p.error', { id: 'target-error', 'aria-live': 'polite' });
  /** Fields with uncommitted input. */
  const typed: Set<HTMLInputElement> = new Set();
  const targets = AXES.map((axis, at) => {
    const field = element('input.number', {
      type: 'text',
      autocomplete: 'off',
      spellcheck: 'false',
      title: '1.5, 1/3 or 20cm; +0.5 moves by that much',
      'aria-label': `Target ${axis}`,
      'aria-describedby': error.id,
      oninput: () => typed.add(field),
      onchange: () => move(at),
      onkeydown: (event: KeyboardEvent) => {
        if (event.key !== 'Escape' || !typed.has(field)) return;
        event.stopPropagation();
        discardInput(field);
      },
      // Invalid input stays, to be corrected.
      onblur: () => field.hasAttribute('aria-invalid') || discardInput(field),
    });
    return field;
  });
  const place = element(
    'div.target',
    ...targets.map((field, i) => element('label', AXES[i], field)),
  );
  const kind = (label: string, fixed: boolean) =>
    element(
      'button',
      {
        // Handles of this kind already keep their weight.
        onclick: () => {
          const others = vertices((handle) => handle.fixed !== fixed);
          if (others.length > 0) void actions.addHandles(others, fixed);
        },
      },
      label,
    );
  const [soft, fixed] = [kind('Soft', false), kind('Fixed', true)];
  const weight = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    'aria-label': 'Weight of the handle',
    oninput: () => typed.add(weight),
    onchange: () => {
      typed.delete(weight);
      const value = weight.valueAsNumber;
      if (!(value > 0)) return show();
      void actions.edit({
        weighHandles: { vertices: vertices((handle) => !handle.fixed), weight: value },
      });
    },
    // Input that ends at the value shown before changes nothing.
    onblur: () => discardInput(weight),
  });
  const weightLabel = element('label', 'weight', weight);
  const group = element(
    'div.handle-details',
    { role: 'group', 'aria-label': 'Selected handles' },
    title,
    place,
    error,
    element('div.hold', element('span.segmented', soft, fixed), weightLabel),
  );

  /** Discards the input of a field. */
  function discardInput(field: HTMLInputElement) {
    typed.delete(field);
    show();
  }

  /**
   * Shows a value if it is common to all handles.
   * @param field unchanged while it has uncommitted input
   * @param values one for each handle
   */
  function showCommon(field: HTMLInputElement, values: string[]) {
    if (typed.has(field)) return;
    const isCommon = values.every((value) => value === values[0]);
    field.value = isCommon ? (values[0] ?? '') : '';
    field.placeholder = isCommon ? '' : MIXED;
  }

  function show() {
    const selected = new Set(actions.selectedVertices());
    chosen = handlesNow(store.get())
      .filter(({ vertex }) => selected.has(vertex))
      .map((handle) => ({ ...handle, target: ahead.get(handle.vertex) ?? handle.target }));
    group.hidden = chosen.length === 0;
    if (group.hidden) return typed.clear();
    const one = chosen.length === 1;
    setText(title, one ? `Handle at vertex ${chosen[0].vertex}` : count(chosen.length, 'handle'));
    const decimals = decimalsFor(store.get().model?.size ?? 0);
    targets.forEach((field, i) => {
      const values = chosen.map(({ target }) => coordinate(target[i], decimals));
      showCommon(field, values);
      if (!typed.has(field)) field.removeAttribute('aria-invalid');
    });
    if (!targets.some((field) => field.hasAttribute('aria-invalid'))) setText(error, '');
    const longest = Math.max(...targets.map(({ value }) => value.length));
    place.classList.toggle('tall', longest > MOST_BESIDE);
    const held = chosen.filter((handle) => !handle.fixed);
    soft.setAttribute('aria-pressed', String(held.length === chosen.length));
    fixed.setAttribute('aria-pressed', String(held.length === 0));
    weightLabel.hidden = held.length === 0;
    showCommon(
      weight,
      held.map((handle) => String(handle.weight)),
    );
  }
  store.subscribe(['document', 'refused'], () => {
    if (!pending) ahead.clear();
    show();
  });
  // Discard input meant for the previous selection.
  store.subscribe(['selection'], () => {
    typed.clear();
    show();
  });
  store.subscribe(['moved'], throttled(RENEW_MS, show));
  return group;
}
