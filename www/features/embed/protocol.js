/**
 * The messages between a page and the embedded view, by `postMessage`. The parent page posts a
 * `Call` to the frame's window and receives one `Answer` with the same `id`; the view posts `News`
 * unasked. Other messages are ignored. The view accepts calls from its parent only.
 * `embedding.html` explains each call and each piece of news, with an example.
 */

/** @typedef {{ shapeUp: "call", id: number | string } & Asked} Call */
/**
 * @typedef {{ name: "start" | "run" | "pause" | "step" | "reset" | "state" | "scene" | "positions" }
 *   | { name: "open", text: string, as?: string }
 *   | { name: "weight", constraint: number, weight: number }
 *   | { name: "handle", vertex: number, target: [number, number, number] }
 *   | { name: "measure", measure: string | null }
 *   | { name: "camera", camera: number[] }} Asked
 */
/** @typedef {{ shapeUp: "answer", id: number | string, result?: unknown, error?: string }} Answer */
/** @typedef {ReturnType<import("../../app/context.js").AppContext["script"]["state"]>} ViewState */
/**
 * @typedef {{ shapeUp: "news" } & ({ news: "waiting" } | { news: "ready" | "state", state: ViewState }
 *   | { news: "camera", camera: number[] })} News
 */

/** Values of `embed` in the address of a view that was started by a call or by a press. */
export const CALLED = 'called';
export const PRESSED = 'pressed';

/**
 * Returns the call in a message of the parent page, or null.
 * @param {MessageEvent} event
 * @returns {Call | null}
 */
export function callIn({ source, data }) {
  return source === parent && source !== window && data?.shapeUp === 'call' ? data : null;
}

/** @param {News | Answer} message @param {string} [origin] of the parent page */
export const post = (message, origin = '*') => parent.postMessage(message, origin);
