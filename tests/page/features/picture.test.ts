// The legend that is drawn into saved pictures.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pictureOf } from '../../../www/features/export/picture.ts';
import type { State } from '../../../www/store/state.ts';
import { spreadOf } from '../../../www/ui/plot/histogram.ts';
import { axisOf } from '../../../www/ui/plot/value-axis.ts';
import type { Viewport } from '../../../www/viewport/viewport.ts';

/** Saves a picture of the state; returns its words, and its colours by their position. */
async function legendOf(state: object) {
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
  const view = { rampColours: () => ['blue', 'white', 'red'], bandLimits: () => [] };
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

test('the legend of a measure of both signs begins below zero, in one picture and in two', async () => {
  const measure = 'gauss-curvature';
  const about = { id: measure, label: 'Gauss curvature', unit: 'per-area', signed: true };
  const values = Float32Array.of(-0.02, -0.01, 0, 0.01, 0.02);
  const range = [-0.02, 0.02] as const;
  const state = {
    ...{ measures: [about], measure, document: { units: 'm' }, model: { faces: 5 }, dark: false },
    ...{ display: { full: false, log: false }, tolerance: 0.01, tolerances: {}, split: null },
    ...{ range, spread: spreadOf(measure, values, axisOf(...range, false), null) },
  };
  const words = ['Gauss curvature', '−0.0200 1/m²', '0.0200 1/m²'];
  const colours = [
    [0, 'blue'],
    [0.5, 'white'],
    [1, 'red'],
  ];
  assert.deepEqual(await legendOf(state), { words, colours });
  const side = { measure, values, low: -0.02, top: 0.02, tolerance: null };
  const both = await legendOf({ ...state, spread: null, split: { sides: [side, side] } });
  assert.deepEqual(both, { words: [...words, ...words], colours: [...colours, ...colours] });
});

test('the legend of an error begins at zero, and its colours at the tolerance', async () => {
  const measure = 'planarity';
  const about = { id: measure, label: 'Planarity', unit: 'length', toleranced: true };
  const values = Float32Array.of(0.005, 0.01, 0.04);
  const side = { measure, values, low: 0.01, top: 0.04, tolerance: 0.01 };
  const { words, colours } = await legendOf({
    ...{ measures: [about], measure, document: { units: 'm' }, model: { faces: 3 }, dark: false },
    ...{ display: { full: false, log: false }, tolerance: 0.01, tolerances: {} },
    split: { sides: [side, side] },
  });
  assert.equal(words[1], '0');
  assert.equal(colours[0][0], 0.25);
});
