// The legend that is drawn into saved pictures.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pictureOf } from '../../../www/features/export/picture.js';
import { spreadOf } from '../../../www/ui/plot/histogram.js';
import { axisOf } from '../../../www/ui/plot/value-axis.js';

/** Saves a picture of the state; returns its words, and its colours by their position. */
async function legendOf(state) {
  const [words, colours] = [[], []];
  const context = {
    setTransform() {},
    drawImage() {},
    fillRect() {},
    fillText: (text) => words.push(text),
    createLinearGradient: () => ({ addColorStop: (at, colour) => colours.push([at, colour]) }),
    canvas: { toBlob: (done) => done(new Blob()) },
  };
  globalThis.document = /** @type {any} */ ({
    createElement: () => ({ getContext: () => context }),
  });
  globalThis.getComputedStyle = /** @type {any} */ (() => ({ fontFamily: 'sans-serif' }));
  const view = { rampColours: () => ['blue', 'white', 'red'], bandLimits: () => [] };
  const viewport = {
    element: { getBoundingClientRect: () => ({ width: 800, height: 600 }) },
    still(_, grey, take) {
      take({}, 0, 0);
      return true;
    },
    labels: () => [],
    unmeasured: (use) => use(view),
  };
  await pictureOf(/** @type {any} */ (viewport), state, {
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
  const range = /** @type {const} */ ([-0.02, 0.02]);
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
