/**
 * The measuring tape between two vertices: their distance now and in the original model. The
 * distance is shown at the tape, and the components in a small table; both follow the mesh.
 */

import { element, icon, setText } from '../../ui/dom.ts';
import { comparedLengths } from '../../ui/words.ts';
import type { AppContext } from '../../app/context.ts';
import type { Label } from '../../viewport/viewport.ts';

const NAMES = ['Distance', 'dx', 'dy', 'dz'];

export class Tape {
  #app;
  #label = element('div', { id: 'tape-label', 'aria-hidden': 'true', hidden: true });
  #title = element('span');
  /** Cells by row and column. */
  #cells = [0, 1].map(() => NAMES.map(() => element('td.figure')));
  #table = element(
    'table',
    element('tr', element('td'), ...NAMES.map((name) => element('th', { scope: 'col' }, name))),
    ...['now', 'original'].map((name, i) =>
      element('tr', element('th', { scope: 'row' }, name), ...this.#cells[i]),
    ),
  );
  #card;
  /** The vertices last announced: once, not in every iteration. */
  #said = '';

  constructor(app: AppContext) {
    this.#app = app;
    const end = () => app.actions.look({ tape: null });
    const about = { 'aria-label': 'End measuring', title: 'Esc', onclick: end };
    const close = element('button.tiny', about, icon('close'));
    this.#card = element(
      'div.card',
      { id: 'tape', role: 'group', 'aria-label': 'Measuring tape', hidden: true },
      element('div.title', this.#title, close),
      this.#table,
    );
    app.viewport.element.after(this.#label, this.#card);
  }

  /** Updates the card and the label after a frame. */
  show() {
    const { tape, document, heldOriginal } = this.#app.store.get();
    // The numbers are those of the shape, and stay beside the original.
    if (tape && heldOriginal) return this.#place();
    this.#card.hidden = !tape;
    const measured = tape && this.#measured();
    this.#label.hidden = !measured;
    this.#table.hidden = !measured;
    if (!tape) {
      this.#said = '';
      return;
    }
    if (!measured) return this.#ask(tape);
    const { now, rest, unit } = measured;
    setText(this.#title, `Vertices ${tape.join(' and ')}${unit && `, in ${unit}`}`);
    now.forEach((length, i) => setText(this.#cells[0][i], length));
    rest.forEach((length, i) => setText(this.#cells[1][i], length));
    setText(this.#label, `${now[0]} ${unit}`);
    this.#place();
    const about = tape.join(' ');
    // Waits for the original distance, which arrives a moment later.
    if (about === this.#said || rest.length === 0) return;
    this.#said = about;
    const unitOf = document?.units ? ` ${unit}` : '';
    this.#app.actions.setStatus(`Distance ${now[0]}${unitOf}, originally ${rest[0]}${unitOf}`);
  }

  #ask(tape: number[]) {
    this.#said = '';
    setText(this.#title, tape.length === 0 ? 'Click two vertices' : 'Click the other vertex');
  }

  /** Distance, dx, dy, dz now and at rest, in words, with their unit; null if incomplete. */
  #measured() {
    const numbers = this.#app.viewport.view?.measured();
    if (!numbers) return null;
    const units = this.#app.store.get().document?.units ?? '';
    // dx, dy, dz now, and then those at rest if they are known.
    const all = [...numbers];
    const ways = [all.slice(0, 3), all.slice(3)].filter((way) => way.length > 0);
    const lengths = ways.flatMap((way) => [Math.hypot(...way), ...way]);
    const { lengths: words, unit } = comparedLengths(Float64Array.from(lengths), units);
    return { now: words.slice(0, 4), rest: words.slice(4), unit };
  }

  #middle(): number[] | undefined {
    const at = this.#app.viewport.view?.tapeMiddle();
    return at && [...at];
  }

  /** Places the label at the middle of the tape, or hides it if that is outside the view. */
  #place() {
    const at = this.#middle();
    const { clientWidth, clientHeight } = this.#app.viewport.element;
    const isSeen = at && at[0] > 0 && at[1] > 0 && at[0] < clientWidth && at[1] < clientHeight;
    this.#label.hidden = !isSeen;
    if (isSeen) this.#label.style.translate = `calc(${at[0]}px - 50%) calc(${at[1]}px - 50%)`;
  }

  /** The label for a saved picture. */
  labels(): Label[] {
    const measured = this.#app.store.get().tape && this.#measured();
    const at = this.#middle();
    if (!measured || !at) return [];
    const text = `${measured.now[0]} ${measured.unit}`;
    return [{ text, x: at[0], y: at[1] + 4, align: 'center', bar: 0 }];
  }
}
