/**
 * The messages between a page and the embedded view, by `postMessage`. The parent page posts a
 * `Call` to the frame's window and receives one `Answer` with the same `id`; the view posts `News`
 * unasked. Other messages are ignored. The view accepts calls from its parent only.
 * `embedding.html` explains each call and each piece of news, with an example.
 */

import type { AppContext } from '../../app/context.ts';

export type Call = { shapeUp: 'call'; id: number | string } & Asked;
export type Asked =
  | { name: 'start' | 'run' | 'pause' | 'step' | 'reset' | 'state' | 'scene' | 'positions' }
  | { name: 'open'; text: string; as?: string }
  | { name: 'weight'; constraint: number; weight: number }
  | { name: 'handle'; vertex: number; target: [number, number, number] }
  | { name: 'measure'; measure: string | null }
  | { name: 'camera'; camera: number[] };
export type Answer = { shapeUp: 'answer'; id: number | string; result?: unknown; error?: string };
export type ViewState = ReturnType<AppContext['script']['state']>;
export type News = { shapeUp: 'news' } & (
  | { news: 'waiting' }
  | { news: 'ready' | 'state'; state: ViewState }
  | { news: 'camera'; camera: number[] }
);

/** Values of `embed` in the address of a view that was started by a call or by a press. */
export const CALLED = 'called';
export const PRESSED = 'pressed';

/** Returns the call in a message of the parent page, or null. */
export function callIn({ source, data }: MessageEvent): Call | null {
  return source === parent && source !== window && data?.shapeUp === 'call' ? data : null;
}

/** @param origin of the parent page */
export const post = (message: News | Answer, origin: string = '*') =>
  parent.postMessage(message, origin);
