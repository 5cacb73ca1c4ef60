// What the mouse and the keys of a browser do, as both versions of WebDriver ask for it.

/** @typedef {[x: number, y: number]} Place in CSS pixels of the window */

const MOVE_MS = 30;
/** The codes of WebDriver for keys without a character. */
const KEYS = { Alt: '\uE00A' };

/**
 * Returns the actions that press the mouse at the first place, move along the way, and release it at
 * the last, while keys are held.
 * @param {Place[]} way
 * @param {string[]} keys
 */
export function actionsOf(way, keys = []) {
  const move = ([x, y]) => ({
    ...{ type: 'pointerMove', duration: MOVE_MS },
    ...{ x: Math.round(x), y: Math.round(y) },
  });
  const [first, ...others] = way;
  const mouse = [
    move(first),
    { type: 'pointerDown', button: 0 },
    ...others.map(move),
    { type: 'pointerUp', button: 0 },
  ];
  const pauses = mouse.slice(2).map(() => ({ type: 'pause' }));
  const held = keys.map((key) => ({
    ...{ type: 'key', id: key },
    actions: [
      { type: 'keyDown', value: KEYS[key] },
      ...pauses,
      { type: 'pause' },
      { type: 'keyUp', value: KEYS[key] },
    ],
  }));
  return [{ type: 'pointer', id: 'mouse', actions: mouse }, ...held];
}
