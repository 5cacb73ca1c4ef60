/** Actions on the display and the selection, which do not concern the solver. */

import { NOTHING } from './selection.ts';
import type { BetterPress } from '../pkg/engine/shape_up.js';
import { getItem, setItem } from '../ui/safe-storage.ts';
import {
  AUTOMATIC,
  MOUSE_SETTINGS,
  type Marking,
  type PanelPress,
  type State,
  type Store,
  type Tint,
} from './state.ts';

/** Storage key of the mouse. */
const MOUSE = 'shape-up.mouse';

/** What the solver says, and what has an action that does more than set it. */
type Owned =
  | (
      | 'kinds'
      | 'measures'
      | 'operations'
      | 'settings'
      | 'model'
      | 'document'
      | 'numbers'
      | 'halfway'
    )
  | ('running' | 'converged' | 'greatest' | 'display' | 'ownRange' | 'tolerances')
  | ('mouse' | 'press' | 'closedCard' | 'tints');

export function createViewActions(store: Store) {
  const mouse = MOUSE_SETTINGS.find((one) => one === getItem(MOUSE));
  if (mouse) store.set({ mouse });
  return {
    /** @param status last event, as text */
    setStatus: (status: string) => store.set({ status }),

    /** As the user wishes, whatever a press shows or hides. */
    display: (change: Partial<State['display']>) =>
      store.set({
        display: { ...store.get().display, ...change },
        ...('shapes' in change && { fitted: null }),
      }),

    /** Sets the measure that colours the faces. */
    colourBy: (measure: State['measure']) => store.set({ measure, measureChosen: true }),

    /** @param change of the range of the colours */
    setRange: (change: Partial<State['ownRange']>) =>
      store.set({ ownRange: { ...store.get().ownRange, top: null, ...change } }),

    /** Ends the range of the colours at the worst face of the current shape. */
    fitRange() {
      const { spread, range } = store.get();
      if (!spread || spread.greatest <= Math.max(range[0], 0))
        return store.set({ ownRange: AUTOMATIC });
      const { greatest } = spread;
      store.set({ ownRange: { low: null, high: greatest, top: greatest } });
    },

    /** Says that a card has left the corner. */
    leaveCorner(corner: State['corner']) {
      if (store.get().corner === corner) store.set({ corner: null });
    },

    /** Adds the presses that end better to the verdict, if it is still that on this shape. */
    suggest(shape: number | undefined, suggestions: BetterPress[]) {
      const { verdict } = store.get();
      if (!verdict || verdict.shape !== shape) return;
      store.set({ verdict: { ...verdict, report: { ...verdict.report, suggestions } } });
    },

    /** Sets the last press that made all panels one shape; its card is shown. */
    pressed: (press: PanelPress) => store.set({ press, closedCard: false }),
    /** Changes what is known of a press, while it is the last one. */
    updatePress(press: PanelPress, change: Partial<PanelPress>): PanelPress {
      const changed = { ...press, ...change };
      if (store.get().press === press) store.set({ press: changed });
      return changed;
    },
    /** Puts back what a press that was refused has changed, unless another one has come. */
    pressRefused(press: PanelPress, { press: last, closedCard, fitted }: Readonly<State>) {
      if (store.get().press !== press) return;
      // An earlier one may have been refused meanwhile.
      store.set({ press: last && { ...last, isUnderWay: false }, closedCard, fitted });
    },
    /** Closes the card of the panels, for this mesh. */
    closePanelsCard: () => store.set({ closedCard: true }),

    /** Sets the tolerance of another measure, in its unit. */
    setToleranceOf: (id: string, value: number | null) =>
      store.set({ tolerances: { ...store.get().tolerances, [id]: value } }),

    /** Marks elements for a cause, in place of those that were; null when it is over. */
    tint: (cause: Marking, tint: Tint | null) =>
      store.set({ tints: { ...store.get().tints, [cause]: tint } }),

    /** Sets parts of the state that nothing else has to follow. */
    look: (change: Partial<Omit<State, Owned>>) => store.set(change),

    /** Chooses what the mouse buttons do, now and at later visits. */
    chooseMouse(mouse: State['mouse']) {
      store.set({ mouse });
      setItem(MOUSE, mouse);
    },

    /** Selects only the faces if there are any, else the edges, else the vertices. */
    select({
      vertices,
      edges = [],
      faces,
    }: {
      vertices: Iterable<number>;
      edges?: Iterable<number>;
      faces: Iterable<number>;
    }) {
      const sets = { faces: new Set(faces), edges: new Set(edges), vertices: new Set(vertices) };
      const mode = sets.faces.size > 0 ? 'faces' : sets.edges.size > 0 ? 'edges' : 'vertices';
      store.set({ mode, selection: { ...NOTHING, [mode]: sets[mode] } });
    },

    selectNothing: () => store.set({ selection: NOTHING }),
  };
}
