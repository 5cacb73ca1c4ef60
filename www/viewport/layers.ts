/** Functions that transfer parts of the state to the view: colours, handles, selection etc. */

import { areHandlesLocked, handlesNow } from '../store/handles.ts';
import { declared, toleranceOf } from '../store/colours/measures.ts';
import { MARKINGS, showsFitted, type State, type FlatMap } from '../store/state.ts';
import type { View } from '../pkg/view-webgl2/shape_up.js';
import type { Geometry } from '../solver/solver-client.ts';
import type { FlatMap as Parametrization } from '../pkg/engine/shape_up.js';

export type { View } from '../pkg/view-webgl2/shape_up.js';

const NONE = new Uint32Array(0);
const FINGERS = matchMedia('(pointer: coarse)');
const NO_COLOURS = {
  faces: new Uint8Array(0),
  vertices: new Uint8Array(0),
  palette: new Float32Array(0),
};

/** Display functions, each with the parts of the state that it depends on. */
export const LAYERS: [
  (keyof State)[],
  (view: View, state: State, geometry: Geometry | null) => void,
][] = [
  [['dark'], (view, state) => view.setTheme(state.dark)],
  [['document'], (view, { document }) => document && view.setUp(document.up)],
  [['display', 'fitted', 'model', 'halfway', 'heldOriginal', 'document'], showDisplay],
  [['parallel'], (view, { parallel }) => view.setParallel(parallel)],
  [
    ['section', 'model'],
    (view, { section }) => view.setSection(section?.axis, section?.at ?? 0, !!section?.turned),
  ],
  [['tape'], (view, { tape }) => view.setTape(Uint32Array.from(tape ?? []))],
  [
    [
      'document',
      'dragged',
      'moved',
      'pointedAt',
      'selection',
      'model',
      'heldOriginal',
      'presenting',
    ],
    showHandles,
  ],
  [
    ['gizmoPart', 'dragged'],
    (view, state) => view.highlightGizmo(state.gizmoPart, state.dragged.length > 0),
  ],
  [['selection', 'model'], showSelection],
  [['docked', 'document', 'model'], showSeams],
  [['tints', 'model', 'heldOriginal'], showTint],
  [['rowColours', 'model', 'flatMap'], showRowColours],
  [['measure', 'range', 'document', 'tolerances', 'display', 'flatMap'], showValues],
  [['flatMap'], showFlatMap],
];

export function showValues(view: View, state: State, geometry: Geometry | null) {
  const { heldOriginal } = state;
  const isCurrent = geometry?.measure === state.measure && !state.flatMap && !heldOriginal;
  view.setCornerValues((isCurrent && geometry?.corners) || undefined);
  if (state.flatMap) {
    // Distortion has one look on the model, on the map and in the legend, whatever is chosen for measures.
    view.setColourMap('viridis');
    view.setBands(false);
    return view.setFaceValues(...modelErrors(state.flatMap));
  }
  // Just after the measure was changed, the values are still the old ones, or have no range yet.
  const isRanged = geometry?.measure === state.measure && state.spread;
  const values = isRanged ? (heldOriginal ?? geometry)?.values : null;
  const { bands, full, log, map } = state.display;
  const about = declared(state, state.measure);
  const allowed = about && toleranceOf(state, about);
  const tolerance = full ? null : allowed;
  const isLog = log && !about?.signed;
  view.setColourMap(map, allowed ?? undefined);
  view.setBands(bands);
  view.setFaceValues(values ?? undefined, ...state.range, tolerance ?? undefined, isLog);
}

export function showDisplay(view: View, state: State) {
  const { display, halfway, heldOriginal, document } = state;
  const { edges, vertices } = display;
  // All of these show the current shape, not the original. Outlines also show during a half step, when
  // the projections are computed but not yet applied.
  const [shapes, outlines, arrows] = heldOriginal
    ? [false, false, false]
    : [showsFitted(state), display.outlines || halfway, display.arrows];
  view.setDisplay(edges, vertices, shapes, outlines, arrows, !heldOriginal);
  view.setSurroundings(display.ghost, display.ground);
  view.setGizmo(display.gizmo && !areHandlesLocked(document), FINGERS.matches);
}

/** Transfers the handles. States: 0 soft, 1 fixed, 2 under the pointer or dragged. */
function showHandles(view: View, state: State) {
  const { dragged, pointedAt } = state;
  // Targets refer to the current shape, not to the original; an audience has no use for them.
  const handles = state.heldOriginal || state.presenting ? [] : handlesNow(state);
  const vertices = Uint32Array.from(handles, (handle) => handle.vertex);
  const states = Uint8Array.from(handles, (handle) =>
    handle.vertex === pointedAt || dragged.includes(handle.vertex) ? 2 : handle.fixed ? 1 : 0,
  );
  const targets = Float64Array.from(handles.flatMap((handle) => handle.target));
  view.setHandles(vertices, states, targets);
}

function showSelection(view: View, { selection }: State) {
  view.setSelection(Uint32Array.from(selection.vertices), Uint32Array.from(selection.faces));
  view.setSelectedEdges(Uint32Array.from(selection.edges));
}

/** Transfers the edges along which paper is cut, while Build makes a paper model. */
function showSeams(view: View, { docked, document }: State) {
  const build = docked === 'parts' ? document?.build : null;
  const seams = build?.product === 'paper' ? build.seams : [];
  view.setSeams(Uint32Array.from(seams.flat()));
}

function showTint(view: View, { tints, heldOriginal }: State) {
  const none = { vertices: NONE, faces: NONE, colour: [0, 0, 0] };
  const first = heldOriginal ? undefined : MARKINGS.map((cause) => tints[cause]).find(Boolean);
  const { vertices, faces, colour } = first ?? none;
  const [red, green, blue] = colour.map((byte) => byte / 255);
  view.setTint(vertices, faces, red, green, blue);
}

function showRowColours(view: View, { rowColours, flatMap }: State) {
  const { faces, vertices, palette } = (!flatMap && rowColours) || NO_COLOURS;
  view.setRowColours(faces, vertices, palette);
}

/** Flat map of each view. */
const shown: WeakMap<View, Parametrization> = new WeakMap();

function showFlatMap(view: View, { flatMap }: { flatMap: FlatMap | null }) {
  if (!flatMap) {
    view.clearMap();
    shown.delete(view);
    return;
  }
  const { found, onModel, onMap, squares } = flatMap;
  if (shown.get(view) !== found) view.setMap(found.uv, found.flippedFaces);
  shown.set(view, found);
  const values = onMap === 'errors' ? found.faceErrors : undefined;
  view.setMapLooks(squares, onModel === 'checks', onMap === 'checks', values, 1, found.high);
}

/** Returns the values that colour the model's faces while its map is shown, and their range. */
function modelErrors({ found, onModel }: FlatMap): [Float32Array | undefined, number, number] {
  return [onModel === 'errors' ? found.faceErrors : undefined, 1, found.high];
}
