/** A video of the model turning once, in browsers that can record a canvas. */

import type { Viewport } from '../../viewport/viewport.ts';

const SECONDS = 6;
/** Video formats in order of preference. */
const KINDS = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
/** Bits per second, high enough for crisp lines. */
const BITS = 16e6;

const kind = () => KINDS.find((name) => globalThis.MediaRecorder?.isTypeSupported(name));

export const canRecord = () =>
  kind() !== undefined && typeof HTMLCanvasElement.prototype.captureStream === 'function';

/**
 * Turns the model once, records it as WebM, and restores the camera.
 * @param replaced aborted when another model is shown, which ends the video
 * @param seconds for the turn
 */
export async function turntableVideo(
  viewport: Viewport,
  replaced: AbortSignal,
  seconds: number = SECONDS,
): Promise<Blob> {
  const stream = canRecord() ? viewport.stream() : undefined;
  if (!stream) throw new Error('This browser cannot record a video of the view.');
  const recorder = new MediaRecorder(stream, { mimeType: kind(), videoBitsPerSecond: BITS });
  const parts: Blob[] = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const stopped = new Promise((done, failed) => {
    recorder.onstop = done;
    recorder.onerror = () => failed(new Error('The browser could not record the video.'));
  });
  const camera = viewport.with((view) => {
    viewport.arrive();
    viewport.motion = null;
    return view.camera();
  });
  recorder.start();
  await turnOnce(viewport, seconds, replaced);
  recorder.stop();
  stream.getTracks().forEach((track) => track.stop());
  // The camera is that of the other model.
  replaced.throwIfAborted();
  if (camera) viewport.with((view) => view.placeCamera(camera));
  await stopped;
  return new Blob(parts, { type: 'video/webm' });
}

function turnOnce(viewport: Viewport, seconds: number, replaced: AbortSignal) {
  const began = performance.now();
  let part = 0;
  return new Promise((done) => {
    const turn = () => {
      if (replaced.aborted) return done(undefined);
      const now = Math.min(1, (performance.now() - began) / 1000 / seconds);
      viewport.unmeasured((view) => view.spin(2 * Math.PI * (now - part)));
      part = now;
      requestAnimationFrame(now < 1 ? turn : () => done(undefined));
    };
    requestAnimationFrame(turn);
  });
}
