// Motions of the camera: where flights lead, and what ends them and turning.

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

type Motions = typeof import('../../../www/viewport/camera.ts');

const toTop = ({ fly }: Motions, viewport: Viewport) =>
  fly(viewport, (view) => view.placeCamera(TO));

/**
 * Begins a motion at FROM with the given functions; `meanwhile` may change the camera in its second
 * frame, after 160 ms. Returns the camera after a second.
 */
async function moved(
  begin: (of: Motions, viewport: Viewport) => void,
  meanwhile: (camera: Float64Array, of: Motions, viewport: Viewport) => void,
) {
  let now = 0;
  let next: (() => void) | null = null;
  const page = { matchMedia: () => ({ matches: false }), performance: { now: () => now } };
  const frames = { requestAnimationFrame: (then: () => void) => (next = then) };
  const before = Object.getOwnPropertyDescriptors(globalThis);
  for (const [name, value] of Object.entries({ ...page, ...frames }))
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  try {
    const motions = await import('../../../www/viewport/camera.ts');
    let camera = FROM.slice();
    const view = {
      camera: () => camera.slice(),
      placeCamera: (numbers: Float64Array) => (camera = numbers.slice()),
      spin(angle: number) {
        camera[4] += angle;
        camera[6] = 0;
      },
    };
    const fake = {
      motion: null as Viewport['motion'],
      with: (action: (of: typeof view) => unknown) => action(view),
      unmeasured: (action: (of: typeof view) => unknown) => action(view),
      arrive() {
        if (!this.motion?.to) return;
        view.placeCamera(this.motion.to);
        this.motion = null;
      },
    };
    const viewport = fake as unknown as Viewport;
    begin(motions, viewport);
    assert.deepEqual(camera.slice(0, 6), FROM.slice(0, 6), 'it begins where the camera was');
    for (now = 80; next && now < 1000; now += 80) {
      const frame: () => void = next;
      next = null;
      frame();
      if (now === 160) meanwhile(camera, motions, viewport);
    }
    return camera;
  } finally {
    for (const name of Object.keys({ ...page, ...frames }))
      if (before[name as keyof typeof before])
        Object.defineProperty(globalThis, name, before[name as keyof typeof before]);
  }
}

test('a model that is framed during a flight does not end it halfway', async () => {
  const end = await moved(toTop, (camera) => {
    camera[3] = 5;
    camera[6] = 1;
  });
  assert.deepEqual(end, TO);
});

test('who moves the camera ends the flight', async () => {
  const end = await moved(toTop, (camera) => void (camera[4] += 0.3));
  assert.notDeepEqual(end, TO);
  assert.equal(end[6], 0);
});

test('a model turns until a view is chosen, the camera is moved, or turning ends', async () => {
  const turn = ({ turnSlowly }: Motions, viewport: Viewport) => turnSlowly(viewport);
  const after = (...of: Parameters<typeof moved>) =>
    moved(...of).then((camera) => camera[4] - FROM[4]);
  const inRadians = (seconds: number) => (2 * Math.PI * seconds) / 24;
  const whole = await after(turn, () => {});
  assert.ok(Math.abs(whole - inRadians(0.96)) < 1e-9, `${whole}`);
  // The flight ended in its first frame, and the model turned on.
  assert.deepEqual(await moved(turn, (_, motions, viewport) => toTop(motions, viewport)), TO);
  const early = inRadians(0.16);
  const pushed = await after(turn, (camera) => void (camera[4] += 0.3));
  assert.ok(Math.abs(pushed - early - 0.3) < 1e-9, `${pushed}`);
  for (const end of ['turnSlowly', 'stopTurning'] as const) {
    const stopped = await after(turn, (_, motions, viewport) => motions[end](viewport));
    assert.ok(Math.abs(stopped - early) < 1e-9, `${end}: ${stopped}`);
  }
});
