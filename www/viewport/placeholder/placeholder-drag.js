/**
 * Makes the handles of the placeholder picture draggable from the first paint on. The build inlines
 * this script into the page's HTML, because no module is loaded that early; placeholder-scene.js
 * takes the drags over once the solver is ready.
 */

(() => {
  /** Distance in CSS pixels within which a pointer hits a dot. */
  const NEAR = 16;
  /** @type {import("./placeholder-scene.js").EarlyDrags} */
  const early = { drags: [], changed() {} };
  Object.assign(window, { earlyDrags: early });

  window.addEventListener('pointerdown', (press) => {
    const { target, button, isPrimary, pointerId, clientX, clientY } = press;
    if (button !== 0 || !isPrimary || !(target instanceof Element)) return;
    const picture = [...document.querySelectorAll('#first-picture svg')].find(
      (svg) => svg.getClientRects().length > 0,
    );
    if (!(picture instanceof SVGSVGElement) || !target.closest('#main')) return;
    const grips = [...picture.querySelectorAll('g[data-vertex]')].map((group) => {
      const dot = /** @type {SVGGElement} */ (group.lastElementChild);
      const { left, top, width, height } = dot.getBoundingClientRect();
      const apart = Math.hypot(left + width / 2 - clientX, top + height / 2 - clientY);
      return { group: /** @type {SVGGElement} */ (group), dot, apart };
    });
    const grip = grips.sort((a, b) => a.apart - b.apart)[0];
    const toPicture = picture.getScreenCTM()?.inverse();
    if (!grip || grip.apart > NEAR || !toPicture) return;

    /** @type {(event: PointerEvent) => [number, number]} */
    const at = (event) => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(toPicture);
      return [x, y];
    };
    const { group, dot } = grip;
    const from = at(press);
    const [[vertex], right, down] = ['vertex', 'right', 'down'].map((name) =>
      (group.dataset[name] ?? '').split(' ').map(Number),
    );
    /** @type {import("./placeholder-scene.js").EarlyDrag} */
    const drag = { vertex, from, to: from, right, down, ended: false };
    early.drags.push(drag);

    // A soft handle's target moves; a fixed handle has no separate target.
    const moved = /** @type {SVGGElement} */ (group.querySelector('.target') ?? dot);
    const pull = group.querySelector('path');
    const { x, y, width, height } = moved.getBBox();
    const before = moved.transform.baseVal.consolidate()?.matrix;
    const start = [before?.e ?? 0, before?.f ?? 0];

    /** @param {PointerEvent} event */
    const move = (event) => {
      if (event.pointerId !== pointerId) return;
      drag.to = at(event);
      const [dx, dy] = [0, 1].map((axis) => start[axis] + drag.to[axis] - from[axis]);
      moved.setAttribute('transform', `translate(${dx} ${dy})`);
      const tip = `L${x + width / 2 + dx} ${y + height / 2 + dy}`;
      pull?.setAttribute('d', `${pull.getAttribute('d')?.split('L')[0]}${tip}`);
      early.changed();
    };
    /** @param {PointerEvent} event */
    const end = (event) => {
      if (event.pointerId !== pointerId) return;
      drag.ended = true;
      listening.abort();
      early.changed();
    };
    const listening = new AbortController();
    const { signal } = listening;
    addEventListener('pointermove', move, { signal });
    addEventListener('pointerup', end, { signal });
    addEventListener('pointercancel', end, { signal });
  });
})();
