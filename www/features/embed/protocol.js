/**
 * What another page and the embedded view say to each other with `postMessage`. The page around posts
 * a `Call` to the frame's window and gets one `Answer` with the same `id`; the view posts `News` by
 * itself. Messages that are no calls are left alone. The view takes calls from its parent only.
 *
 * ```js
 * frame.contentWindow.postMessage({ shapeUp: 'call', id: 1, name: 'run' }, origin);
 * addEventListener('message', ({ source, data }) => {
 *   if (source === frame.contentWindow && data.shapeUp === 'answer') console.log(data.id, data.result);
 * });
 * ```
 *
 * | call | arguments | answers |
 * |---|---|---|
 * | `start` | | nothing; starts a view that waits for a click |
 * | `open` | `text` of a mesh or a scene; `as`: its file name | what was opened |
 * | `run`, `pause`, `step`, `reset` | | nothing |
 * | `weight` | `constraint` in the list, from 0, `weight` | nothing |
 * | `handle` | `vertex`, `target` [x, y, z]: makes it one and moves it there | nothing |
 * | `measure` | `measure`: id, or null for the plain material | nothing |
 * | `camera` | `camera`: numbers of the news with that name | nothing |
 * | `state`, `scene`, `positions` | | as `window.shapeUp` gives them |
 *
 * | news | with |
 * |---|---|
 * | `waiting` | nothing: the view starts with a click or a call |
 * | `ready` | `state` of the model that was opened |
 * | `state` | `state`, whenever it changed, at most once per picture |
 * | `camera` | `camera`, when somebody turned the view |
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

/** Values of `embed` in the address of a view that was started by a call, or by a press. */
export const CALLED = 'called';
export const PRESSED = 'pressed';

/**
 * The call in a message of the page around, or null.
 * @param {MessageEvent} event
 * @returns {Call | null}
 */
export function callIn({ source, data }) {
  return source === parent && source !== window && data?.shapeUp === 'call' ? data : null;
}

/** @param {News | Answer} message @param {string} [origin] of the page around */
export const post = (message, origin = '*') => parent.postMessage(message, origin);
