// The legend that is drawn into saved pictures.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pictureOf } from '../../../www/features/export/picture.ts';
import type { State } from '../../../www/store/state.ts';
import type { Viewport } from '../../../www/viewport/viewport.ts';

/** Saves a picture of the state; returns its words, and its colours by their position. */
async function legendOf(state: object, limits: number[] = []) {
  const words: string[] = [];
  const colours: [number, string][] = [];
  const context = {
    setTransform() {},
    drawImage() {},
    fillRect() {},
    fillText: (text: string) => words.push(text),
    createLinearGradient: () => ({
      addColorStop: (at: number, colour: string) => colours.push([at, colour]),
    }),
    canvas: { toBlob: (done: (blob: Blob) => void) => done(new Blob()) },
  };
  globalThis.document = {
    createElement: () => ({ getContext: () => context }),
  } as unknown as Document;
  globalThis.getComputedStyle = (() => ({
    fontFamily: 'sans-serif',
  })) as unknown as typeof getComputedStyle;
  const view = { rampColours: () => ['blue', 'white', 'red'], bandLimits: () => limits };
  const viewport = {
    element: { getBoundingClientRect: () => ({ width: 800, height: 600 }) },
    still(_: object, grey: number | undefined, take: (...tile: unknown[]) => void) {
      take({}, 0, 0);
      return true;
    },
    labels: () => [],
    unmeasured: (use: (given: object) => unknown) => use(view),
  } as unknown as Viewport;
  await pictureOf(viewport, state as State, {
    scale: 1,
    legend: true,
    ground: 'white',
  });
  return { words, colours };
}

/** What the state has of every model in these tests. */
const SHOWN = {
  ...{ document: { units: 'm', tolerance: 0.01 }, tolerances: {}, dark: false },
  display: { full: false, log: false },
};

test('the legend of a measure of both signs begins below zero, and has the steps of its bands', async () => {
  const measure = 'gauss-curvature';
  const about = { id: measure, label: 'Gauss curvature', unit: 'per-area', signed: true };
  const spread = {
    ...{ measure, greatest: 0.02, faces: 5, within: 5, original: null },
    ...{ axis: { low: -0.02, high: 0.02, log: false }, counts: [1, 1, 1, 1, 1] },
    places: { low: 0, high: 1, tolerance: null },
  };
  const state = { ...SHOWN, measures: [about], measure, model: { faces: 5 }, spread };
  const words = ['Gauss curvature', '−0.0200 1/m²', '0.0200 1/m²'];
  const colours = [
    [0, 'blue'],
    [0.5, 'white'],
    [1, 'red'],
  ];
  assert.deepEqual(await legendOf(state), { words, colours });
  const banded = await legendOf(state, [0.25, 0.75]);
  const steps = [0, 0.25, 0.25, 0.75, 0.75, 1].map((at, i) => [at, colours[Math.floor(i / 2)][1]]);
  assert.deepEqual(banded, { words, colours: steps });
});

test('the legend of an error begins at zero, and its colours at the tolerance', async () => {
  const measure = 'planarity';
  const about = { id: measure, label: 'Planarity', unit: 'length', toleranced: true };
  const spread = {
    ...{ measure, greatest: 0.04, faces: 3, within: 2, original: null },
    ...{ axis: { low: 0, high: 0.04, log: false }, counts: [1, 1, 0, 1] },
    places: { low: 0.25, high: 1, tolerance: 0.25 },
  };
  const state = { ...SHOWN, measures: [about], measure, model: { faces: 3 }, spread };
  const { words, colours } = await legendOf(state);
  assert.equal(words[1], '0');
  assert.equal(colours[0][0], 0.25);
  // Beside a flat map the faces have its colours, and not these.
  assert.deepEqual((await legendOf({ ...state, flatMap: {} })).words, []);
});
