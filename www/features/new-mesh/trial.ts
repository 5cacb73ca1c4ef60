/**
 * The trials of a new mesh: each is opened in place of the one before. Unless the last one is kept,
 * the model that was open before comes back, if there was one.
 */

import { signal } from '@preact/signals';
import { newId } from '../../documents/recent-documents.ts';
import { messageOf } from '../../solver/errors.ts';
import { count } from '../../ui/words.ts';
import type { AppContext } from '../../app/context.ts';
import type { NewPlan } from '../../pkg/engine/shape_up.js';

/** Pause in typing after which the mesh is made. */
const QUIET_MS = 150;

/** What a form asks for. */
export interface Asked {
  /**
   * Returns the mesh, and the vertices on which it stands, to be fixed.
   * @throws why there is no such mesh
   */
  make: () => NewPlan;
  /** called when the mesh is kept */
  kept?: () => void;
}

export class Trial {
  /** What came of the last trial. */
  readonly said = signal('');
  readonly canKeep = signal(true);
  #app;
  #before;
  /** One autosave entry for all trials. */
  #work = newId();
  #label = '';
  #asked: Asked | null = null;
  /** What the last trial was made of. */
  #made: Asked | null = null;
  /** Set while a change waits to be made. */
  #timer = 0;
  /** The last trial that was begun. */
  #making: Promise<void> = Promise.resolve();
  #held: number[] = [];
  #isOpen = true;
  #isKept = false;

  /** @param before the model that is open */
  constructor(app: AppContext, before: Awaited<ReturnType<AppContext['files']['asItIs']>>) {
    this.#app = app;
    this.#before = before;
  }

  /** @returns ends the trials; the model before comes back, unless the mesh is kept */
  begin(close: () => void) {
    const stop = this.#app.files.on('opened', () => this.#isOther() && close());
    return () => {
      stop();
      clearTimeout(this.#timer);
      this.#isOpen = false;
      void this.#takeBack();
    };
  }

  /** @param label of the shape */
  ask(label: string, asked: Asked) {
    this.#label = label;
    this.#asked = asked;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#make(), QUIET_MS);
  }

  async keep(close: () => void) {
    const { files, actions } = this.#app;
    // A number typed last is reported when its field loses the focus to the button that keeps. That
    // stays enabled while the mesh is made: a slow press would otherwise be lost.
    if (this.#timer) this.#make();
    let making;
    while (making !== this.#making) {
      making = this.#making;
      await making;
    }
    if (!this.canKeep.value || !this.#isOpen || this.#isKept) return;
    this.#isKept = true;
    this.#asked?.kept?.();
    try {
      // The next command acts on the mesh with its fixed vertices.
      if (this.#held.length) await this.#hold();
      else files.keepTrial();
    } catch {
      // An alert gives the reason, unless it was cancelled.
      this.#isKept = false;
      return;
    }
    close();
    actions.setStatus(`New mesh: ${this.#label}`);
  }

  #make() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#making = this.#making.then(() => this.#makeOne());
  }

  async #makeOne() {
    const asked = this.#asked;
    if (!asked || asked === this.#made || !this.#isOpen) return;
    this.#made = asked;
    try {
      const { text, supports } = asked.make();
      const bytes = new TextEncoder().encode(text);
      const origin = { ...this.#origin(), trial: true, link: this.#before?.origin.link };
      const loaded = await this.#app.files.open([{ name: `${this.#label}.obj`, bytes }], origin);
      this.canKeep.value = Boolean(loaded);
      if (!loaded) return;
      const vertices = count(loaded.vertices, 'vertex', 'vertices');
      this.said.value = `${count(loaded.faces, 'face')}, ${vertices}.`;
      this.#held = supports;
    } catch (error) {
      this.canKeep.value = false;
      this.said.value = messageOf(error);
    }
  }

  /** Fixes the vertices on which the mesh stands; Undo still reopens the model before. */
  async #hold() {
    const { files, actions } = this.#app;
    await actions.addHandles(this.#held, true);
    const bytes = new TextEncoder().encode(await actions.ask.scene());
    await files.open([{ name: `${files.name}.shapeup.json`, bytes }], this.#origin());
  }

  async #takeBack() {
    const { files } = this.#app;
    if (this.#isKept || this.#isOther()) return;
    const before = this.#before;
    // At once: what the user opens next comes later, and stays. An alert gives the reason of a refusal.
    if (before) return void files.open(before.given, before.origin).catch(() => {});
    await this.#making;
    // The last trial stays as the only model, and is saved as such.
    if (files.origin.trial && !this.#isOther()) files.keepTrial();
  }

  #origin() {
    return { work: this.#work, title: this.#label, before: this.#before, step: 'New mesh' };
  }

  /** Whether a model was opened from elsewhere, which stays: neither a trial nor the one before. */
  #isOther() {
    return ![this.#work, this.#before?.origin.work].includes(this.#app.files.origin.work);
  }
}
