/**
 * The list of constraints. Rows are rebuilt only if the list changes, so that a frame does not
 * replace a field with the focus.
 */

import { amountField, closeButton } from '../../ui/controls/fields.ts';
import { RENEW_MS, element, icon, setAttribute, setText, throttled } from '../../ui/dom.ts';
import { groupDigits, length, limit, part } from '../../ui/format.ts';
import { valueInWords } from '../../ui/kinds/parameter-forms.ts';
import { energyOrZero, lengthOrZero } from '../../ui/rounding.ts';
import { detailsOf, editName } from './details.ts';
import type { ConstraintRow, ParamInfo } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

const NONE = new Uint32Array(0);

export function constraintsPanel(place: HTMLElement, { store, actions }: AppContext) {
  /** Cells with values of the iteration, per row. */
  let cells: { worst: HTMLElement; within: HTMLElement; share: HTMLElement }[] = [];
  /** The row that was just renamed and gets the focus back. */
  let renamed: number | null = null;
  /** The displayed rows, serialised. */
  let shown = '';
  /** The open rows, by key: an index would change with preceding rows. */
  const open: Set<string> = new Set();

  const untint = () => actions.tint(null);

  /** Tints the members of a constraint. */
  async function tint(row: ConstraintRow) {
    const members = await actions.reportErrors(actions.ask.members(row.index));
    const hovered = place.querySelector('.constraint:is(:hover, :focus-within)');
    if (members && hovered?.getAttribute('data-index') === String(row.index)) {
      // Dots on the corners of tinted faces would be redundant.
      const vertices = members.faces.length > 0 ? NONE : members.vertices;
      actions.tint({ faces: members.faces, vertices, colour: row.colour });
    }
  }

  async function selectMembers(row: ConstraintRow) {
    const members = await actions.reportErrors(actions.ask.members(row.index));
    if (members) actions.select(members);
  }

  function rowOf(row: ConstraintRow, key: string) {
    const { kinds, document } = store.get();
    const set = (change: { weight?: number; enabled?: boolean }) =>
      actions.edit({ setConstraint: { index: row.index, ...change } });
    const name = `${row.label} on ${row.on}`;
    const kind = kinds.find(({ id }) => id === row.kind);
    const toggle = element('input', {
      type: 'checkbox',
      role: 'switch',
      'aria-label': `${name}: on`,
      title: row.enabled ? 'On' : 'Off',
      checked: row.enabled,
      onchange: () => set({ enabled: toggle.checked }),
    });
    const weight = amountField(`${name}: weight`, (weight) => set({ weight }));
    weight.show(row.weight);
    const remove = () => {
      untint();
      void actions.edit({ removeConstraint: { index: row.index } });
    };
    const worst = element('span.worst.figure', {
      title: 'The largest distance of a vertex from the shape of this constraint',
    });
    const share = element('span.share.figure.advanced', { title: 'Its share of the total energy' });
    const within = element('span');
    cells.push({ worst, within, share });
    const count = row.count > 1 ? ` (${groupDigits(row.count)})` : '';
    const skipped = row.skipped > 0 ? `, ${groupDigits(row.skipped)} skipped` : '';
    const params = paramsInWords(row, kind?.params ?? [], document?.units ?? '');
    const details = element('div.details', {
      id: `constraint-${row.index}-details`,
      hidden: !open.has(key),
    });
    const fill = () => {
      const own = { select: () => actions.begin(selectMembers(row)), rename: () => rename() };
      details.replaceChildren(...detailsOf(row, name, store, actions, own));
    };
    if (open.has(key)) fill();
    const toggleDetails = () => {
      if (!open.delete(key)) open.add(key);
      details.hidden = !open.has(key);
      opener.setAttribute('aria-expanded', String(open.has(key)));
      if (!open.has(key)) return;
      fill();
      details.scrollIntoView({ block: 'nearest' });
    };
    const rename = () =>
      editName(opener, row.name, kind?.label ?? '', (name) => {
        renamed = row.index;
        void actions.edit({ renameConstraint: { index: row.index, name } });
      });
    const opener = element(
      'button.name',
      {
        'aria-label': `${name}: parameters`,
        'aria-expanded': String(open.has(key)),
        'aria-controls': details.id,
        onclick: toggleDetails,
        ondblclick: rename,
        onkeydown: (event: KeyboardEvent) => event.key === 'F2' && rename(),
      },
      element('span', row.label),
      icon('chevron'),
    );
    return element(
      'li',
      {
        class: `constraint${row.enabled ? '' : ' off'}`,
        'data-index': row.index,
        style: `--chip: rgb(${row.colour.join(' ')})`,
        onpointerenter: (event: PointerEvent) => {
          if (event.pointerType !== 'touch') void tint(row);
        },
        onpointerleave: untint,
        onfocusin: () => tint(row),
        onfocusout: untint,
      },
      element('span.chip'),
      opener,
      element(
        'span.buttons',
        element('label.switch', toggle),
        closeButton(`${name}: remove`, remove, { title: 'Remove' }),
      ),
      element(
        'span.on',
        element('span', `${row.name && `${kind?.label}, `}${row.on}${count}${skipped}${params}`),
        share,
      ),
      element('span.measures', element('label', 'weight', weight.field), worst, within),
      details,
    );
  }

  /** Makes a row with a key that stays unique while other rows come and go. */
  function keyedRow(row: ConstraintRow, index: number, rows: ConstraintRow[]) {
    const alike = rows.slice(0, index).filter(({ kind, on }) => kind === row.kind && on === row.on);
    return rowOf(row, `${row.kind} ${row.on} ${alike.length}`);
  }

  const showNumbers = throttled(RENEW_MS, () => {
    const { numbers, document, model } = store.get();
    if (!document) return;
    const { tolerance } = document;
    const size = model?.size ?? 0;
    document.constraints.forEach((row, i) => {
      const value = numbers?.worst[i];
      if (!cells[i]) return;
      const { worst, within, share } = cells[i];
      const known = row.enabled && value !== undefined;
      const words = (far: number) => length(far, document.units, tolerance);
      setText(worst, known ? `worst ${words(lengthOrZero(value, size))}` : '');
      // The row says what it requires.
      const required = typeof row.require === 'object' ? row.require.within : null;
      const allowed = required ?? tolerance;
      const isWithin = known && value <= allowed;
      const isMet = isWithin && required !== null;
      const side = `${isWithin ? 'within' : 'beyond'} ${limit(allowed, document.units)}`;
      setText(within, known ? (isMet ? 'met' : side) : '');
      setAttribute(within, 'class', isWithin ? 'within met' : 'within');
      const some = known && numbers && energyOrZero(numbers.energy.total, size) > 0;
      setText(share, some ? `${part(numbers.shares[i])} of energy` : '');
    });
  });

  store.subscribe(['document', 'refused'], ({ document, refused }) => {
    if (!document) return;
    const rows = JSON.stringify([document.units, document.constraints, refused]);
    if (rows === shown) return;
    shown = rows;
    cells = [];
    untint();
    const focused = focusedField(place);
    place.replaceChildren(
      document.constraints.length > 0
        ? element('ul', { 'aria-label': 'Constraints' }, ...document.constraints.map(keyedRow))
        : element('p.quiet', 'No constraints yet. Add one, then press Run.'),
    );
    if (focused) {
      const name: HTMLElement | null = place.querySelector(`[data-index="${renamed}"] .name`);
      (name ?? focused())?.focus();
    }
    renamed = null;
    showNumbers();
  });
  store.subscribe(['numbers', 'document'], showNumbers);
}

/** Describes the requirement, and parameters that differ from their defaults. */
function paramsInWords(row: ConstraintRow, params: ParamInfo[], units: string) {
  const changed = params.filter(
    ({ id, default: usual }) => JSON.stringify(row.params[id]) !== JSON.stringify(usual),
  );
  const words = changed.map(
    (param) => `${param.label.toLowerCase()} ${valueInWords(param, row.params[param.id], units)}`,
  );
  if (row.require === 'exact') words.unshift('exact');
  else if (row.require !== 'soft') words.unshift(`within ${limit(row.require.within, units)}`);
  return words.map((one) => ` · ${one}`).join('');
}

/**
 * Returns a function that finds the focused field again in rebuilt rows: by its accessible name, and
 * by its place among fields of that name, as rows on equal elements have equal names.
 */
function focusedField(place: HTMLElement) {
  const { activeElement } = document;
  const label = place.contains(activeElement) && activeElement?.getAttribute('aria-label');
  if (!label) return null;
  const alike = () =>
    [
      ...place.querySelectorAll(`:is(button, input, select)[aria-label="${CSS.escape(label)}"]`),
    ] as HTMLElement[];
  const nth = alike().findIndex((one) => one === activeElement);
  return () => alike()[nth];
}
