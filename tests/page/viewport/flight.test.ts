// Flights of the camera: where they lead, and what ends them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { between } from '../../../www/viewport/flight.ts';
import type { Viewport } from '../../../www/viewport/viewport.ts';

const FROM = Float64Array.of(0, 0, 0, 2, 6, 0.4, 1);
const TO = Float64Array.of(1, 0, 0, 8, 0.5, -0.2, 1);

test('a flight turns the shorter way, and its distance changes by equal factors', () => {
  const middle = between(FROM, TO, 0.5);
  assert.equal(middle[0], 0.5);
  assert.ok(Math.abs(middle[3] - 4) < 1e-12);
  // From 6 over a whole turn to 0.5.
  assert.ok(Math.abs(middle[4] - (3.25 + Math.PI)) < 1e-12);
  assert.equal(middle[6], 0, 'what frames the model does not move it meanwhile');
  const end = between(FROM, TO, 1);
  assert.ok(Math.abs(Math.sin(end[4]) - Math.sin(TO[4])) < 1e-12);
});

/** Flies from FROM to TO; `meanwhile` may change the camera halfway. Returns the last camera. */
async function flown(meanwhile: (camera: Float64Array) => void) {
  let now = 0;
  let next: (() => void) | null = null;
  const page = { matchMedia: () => ({ matches: false }), performance: { now: () => now } };
  const frames = { requestAnimationFrame: (then: () => void) => (next = then) };
  const before = Object.getOwnPropertyDescriptors(globalThis);
  for (const [name, value] of Object.entries({ ...page, ...frames }))
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  try {
    const { fly } = await import('../../../www/viewport/camera.ts');
    let camera = FROM;
    const view = {
      camera: () => camera.slice(),
      placeCamera: (numbers: Float64Array) => (camera = numbers.slice()),
    };
    const viewport = {
      destination: null as Float64Array | null,
      with: (action: (of: typeof view) => unknown) => action(view),
      unmeasured: (action: (of: typeof view) => unknown) => action(view),
      arrive() {
        if (this.destination) view.placeCamera(this.destination);
        this.destination = null;
      },
    };
    fly(viewport as unknown as Viewport, () => void (camera = TO));
    assert.deepEqual(camera.slice(0, 6), FROM.slice(0, 6), 'it begins where the camera was');
    for (now = 80; next && now < 1000; now += 80) {
      const frame: () => void = next;
      next = null;
      frame();
      if (now === 160) meanwhile(camera);
    }
    return camera;
  } finally {
    for (const name of Object.keys({ ...page, ...frames }))
      if (before[name as keyof typeof before])
        Object.defineProperty(globalThis, name, before[name as keyof typeof before]);
  }
}

test('a model that is framed during a flight does not end it halfway', async () => {
  const end = await flown((camera) => {
    camera[3] = 5;
    camera[6] = 1;
  });
  assert.deepEqual(end, TO);
});

test('who moves the camera ends the flight', async () => {
  const end = await flown((camera) => (camera[4] += 0.3));
  assert.notDeepEqual(end, TO);
  assert.equal(end[6], 0);
});
