/** What the solver offers for the selection, asked again whenever that changes. */

import { useMemo, useRef } from 'preact/hooks';
import { useSignal, useSignalEffect } from '@preact/signals';
import { newestOnly } from '../../store/latest-only.ts';
import { useApp } from '../../store/use-app.ts';
import type { ConstraintOffers } from '../../pkg/engine/shape_up.js';

export function useOffers() {
  const { store, actions } = useApp();
  /** Null before the solver has answered. */
  const offers = useSignal<ConstraintOffers | null>(null);
  const newest = useMemo(() => newestOnly(), []);
  /** Resolves when the offers for the latest selection are known. */
  const asking = useRef<Promise<void>>(Promise.resolve());

  async function ask(chosen: Iterable<number>) {
    const { ask, reportErrors, selectedVertices } = actions;
    const vertices = Uint32Array.from(selectedVertices());
    const faces = Uint32Array.from(chosen);
    const found = await newest(reportErrors(ask.constraintOffers(vertices, faces)));
    if (found) offers.value = found;
  }

  useSignalEffect(() => {
    const { model, selection } = store.state;
    if (model) asking.current = ask(selection.faces);
  });

  /** Resolves when what is offered fits the selections begun before. */
  async function upToDate() {
    await actions.settled();
    let before;
    while (before !== asking.current) {
      before = asking.current;
      await before;
    }
  }

  return { offers, upToDate };
}
