/** The parts of the open shape as the panel shows them, made anew when the shape or a setting changes. */

import { batch, computed, signal } from '@preact/signals';
import { withoutPath } from '../../store/actions.ts';
import { latestOnly, MOST_LIVE_VERTICES } from '../../store/latest-only.ts';
import { once } from '../../ui/once.ts';
import { LiveBuild } from './live-build.ts';
import { offsetLayer } from './offset-layer.ts';
import type { WordedChoice } from '../../pkg/engine/shape_up.js';
import type { BuildSettings, Built, Reshaped } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** The parts of the page. */
export const theParts = once((app: AppContext) => new Parts(app));

export class Parts {
  readonly live: LiveBuild;
  /** The presets and the declared settings, once they are known. */
  readonly offers = signal<Awaited<ReturnType<LiveBuild['offers']>> | null>(null);
  readonly built = signal<Built | null>(null);
  /** What depends on the offset and follows a drag. */
  readonly card = signal<Reshaped>(null);
  /** Each kind of offset with its error. */
  readonly choices = signal<WordedChoice[]>([]);
  /** Why there are no parts; empty if there are. */
  readonly refused = signal('');
  #app;
  #layer;
  #isOpen = false;
  /** The settings of the scene. */
  readonly settings = computed<BuildSettings>(() =>
    this.live.settings(this.#app.store.state.document),
  );
  #tried = latestOnly((distance: number | null) =>
    this.#app.actions.reportErrors(
      distance === null ? this.live.again() : this.live.moveLayer(distance),
    ),
  );

  constructor(app: AppContext) {
    this.#app = app;
    this.#layer = offsetLayer(app);
    this.live = new LiveBuild(app, 'panel', {
      show: (built) => this.#show(built),
      showOffset: (card) => this.#showOffset(card),
      refuse: (why) => this.#refuse(why),
    });
  }

  /** Makes the parts, and again whenever something changes, until the returned function is called. */
  begin() {
    const { store, actions } = this.#app;
    this.#isOpen = true;
    void actions.reportErrors(this.#open());
    let { model } = store.get();
    const stop = store.subscribe(['document', 'numbers', 'running', 'dragged', 'model'], (now) => {
      // Panels of another mesh mean nothing here.
      if (now.model !== model) this.#withdraw();
      ({ model } = now);
      if (!model) actions.look({ docked: null });
      else void this.live.update();
    });
    return () => {
      stop();
      this.#isOpen = false;
      this.#withdraw();
      actions.tint('pointed', null);
    };
  }

  /** @param values by the paths of the settings, as in a scene */
  change(values: Record<string, unknown>) {
    return this.#app.actions.edit({ setBuild: { values } }, (error) => this.#refusal(error));
  }

  /** Names the setting of a refusal by its label: several may be wrong together. */
  #refusal(error: unknown) {
    const path = error instanceof Error && 'path' in error ? error.path : '';
    const named = this.offers.value?.settings.find(({ id }) => path === `build.${id}`);
    return `${named ? `${named.label}: ` : ''}${withoutPath(error)}`;
  }

  /**
   * Previews the offset.
   * @param distance in the unit of the mesh; null for that of the settings
   */
  tryDistance(distance: number | null) {
    void this.#tried.ask(distance);
  }

  async #open() {
    this.offers.value ??= await this.live.offers();
    if (this.#isOpen) await this.live.again();
  }

  #show(built: Built) {
    if (!this.#isOpen) return;
    const { report, words, layer } = built;
    batch(() => {
      this.refused.value = '';
      this.built.value = built;
      this.#showOffset({ report, words: words.card, layer });
    });
    this.#app.actions.look({ build: report });
    void this.#app.actions.reportErrors(this.#offerKinds());
  }

  #showOffset(card: Reshaped) {
    if (!this.#isOpen || !card) return;
    this.card.value = card;
    this.#layer.show(card.layer);
  }

  /** Tells the error of each kind of offset, while the shape is at rest. */
  async #offerKinds() {
    const { running, dragged, model } = this.#app.store.get();
    if (running || dragged.length > 0 || (model?.vertices ?? 0) > MOST_LIVE_VERTICES) return;
    const built = this.built.value;
    const choices = await this.live.choices();
    // They are of the parts that are shown.
    if (this.built.value === built) this.choices.value = choices;
  }

  #refuse(why: string) {
    if (!this.#isOpen) return;
    this.#withdraw();
    this.refused.value = why;
  }

  #withdraw() {
    batch(() => {
      this.built.value = this.card.value = null;
      this.choices.value = [];
      this.refused.value = '';
    });
    this.#layer.show(null);
    this.#app.actions.look({ build: null });
  }
}
