/** The lines of the curvature card: what is asked for, and what was found. */

import { signal } from '@preact/signals';
import { RENEW_MS, throttled } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { surfaceLines } from './surface-lines.ts';
import type { AppContext } from '../../app/context.ts';
import type { Lines, LinesQuestion } from '../../solver/types.ts';

type Question = Omit<LinesQuestion, 'shape'>;
const NONE = new Uint32Array(0);

export const curvatureLines = once((app: AppContext) => {
  const { store, solver, actions } = app;
  let asked: Question | null = null;
  const told = signal<{ answer: Lines | null; refused: string }>({ answer: null, refused: '' });
  const drawing = surfaceLines(
    app,
    () => asked,
    (answer, refused) => {
      told.value = { answer, refused };
    },
  );
  const soon = throttled(RENEW_MS, () => drawing.update());

  return {
    /** What was found last. */
    told,

    /**
     * Draws lines on the shape.
     * @param draw null for none
     * @param distance between them; null for one that suits the model
     */
    draw(draw: Question['draw'] | null, distance: number | null) {
      const { mode, selection } = store.get();
      const isThrough = draw === 'through';
      const hasFaces = mode === 'faces';
      asked = draw && {
        ...{ draw, distance },
        vertices: isThrough && !hasFaces ? Uint32Array.from(actions.selectedVertices()) : NONE,
        faces: isThrough && hasFaces ? Uint32Array.from(selection.faces) : NONE,
      };
      soon();
    },

    /** Follows the shape, until the returned function is called, which removes the lines. */
    follow() {
      const stops = [solver.on('frame', soon), store.subscribe(['running', 'model'], soon)];
      return () => {
        stops.forEach((stop) => stop());
        asked = null;
        void drawing.update();
      };
    },
  };
});
