// The next step, which one button and the hint in the status bar propose.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { nextStep } from '../../../www/store/next-step.ts';
import { panelsCard } from '../../../www/store/panels-card.ts';
import type { State } from '../../../www/store/state.ts';

type Known = Parameters<typeof nextStep>[0];

const model = { faces: 4, panels: [{ reason: '' }] };

/** A made model with a good verdict, and what differs. */
function after(change: object = {}) {
  const known = {
    document: { constraints: [{ enabled: true, kind: 'plane' }] },
    ...{ model, press: {}, kinds: [{ id: 'plane', panels: 'flat' }] },
    running: false,
    converged: true,
    numbers: { exact: { met: true } },
    verdict: { shape: 3, report: { level: 'good' } },
    ...change,
  };
  return nextStep(known as unknown as Known);
}

test('the next step is the first that is missing', () => {
  const bare = { constraints: [], handles: [] };
  assert.equal(after({ document: bare }), 'shape');
  // A constraint has to be added: there is nothing to run. Run used to be the blue button.
  const mixed = { faces: 4, panels: [{ reason: 'mixed' }] };
  assert.equal(after({ document: bare, model: mixed }), 'constrain');
  assert.equal(after({ document: bare, model: { ...mixed, panelSuggestion: {} } }), 'change');
  assert.equal(after({ document: { ...bare, handles: [{ vertex: 0 }] }, model: mixed }), 'run');
  assert.equal(after({ converged: false }), 'run');
  assert.equal(after({ running: true }), 'run');
  // Nothing is constrained, but a handle is pulled: Pause was filled, and a button for the panels.
  assert.equal(after({ document: bare, running: true }), 'run');
  assert.equal(after({ numbers: { exact: { met: false } } }), 'run');
  assert.equal(after({ model: { faces: 0, panels: [] } }), 'run');
  assert.equal(after(), 'build');
});

test('a run whose constraints are only weighed may end beyond the tolerance', () => {
  // Build used to be the blue button beside "304 of 2040 panels".
  const document = { constraints: [{ enabled: true, require: 'soft' }], tolerance: 0.001 };
  const far = { worst: [0.011] };
  assert.equal(after({ document, numbers: far }), 'choose');
  assert.equal(after({ document, numbers: { worst: [0.0009] } }), 'build');
  const off = { constraints: [{ enabled: false, require: 'soft' }, { enabled: true }] };
  assert.equal(after({ document: { ...document, ...off }, numbers: far }), 'build');
});

test('what is not good is not to be built, unless its verdict was closed', () => {
  // It used to be "Next: Build" beside the words that half of the roof is lost.
  const poor = { shape: 3, report: { level: 'poor' } };
  assert.equal(after({ verdict: poor }), 'choose');
  assert.equal(after({ verdict: poor, closedCard: true }), 'build');
  assert.equal(after({ verdict: null }), 'build');
});

test('what a lesson locks is not the next step, and no card over the view offers it', () => {
  // The card was disabled with its cross, and stayed over the view.
  const lesson = { lock: ['constraints'] };
  const document = { constraints: [], handles: [], lesson };
  assert.equal(after({ document }), 'run');
  const model = { faces: 4, panels: [{}] };
  const card = (more: object) => panelsCard({ model, ...more } as unknown as State);
  assert.equal(card({ document }), null);
  assert.equal(card({ document: { ...document, lesson: null } }), 'offer');
});
