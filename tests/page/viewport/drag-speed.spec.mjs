// Dragging on a large mesh is fast: what the page and the worker take for a move. The view does all
// of its own work, but nothing is rasterised: here that is done in software, and would be measured
// instead. The work of the page is counted by the shapes that it shows, not by the pictures: while the
// worker is still computing, a picture shows the dot at the pointer and nothing else that is new.

import { showPanel } from '../actions.mjs';
import { expect, screenOf, state, test, visit, waitForState } from '../support.mjs';

/** The example with about 2500 vertices. */
const EXAMPLE = 'fig-05-mixed';
/**
 * Both budgets are parts of what other work takes in the same browser meanwhile, because machines differ and
 * other programs have them too. Where this was written that is 2.7 ms, the page takes 2.8 and the answer 15.
 *
 * The processor's time of the page's main thread for each shape:
 */
const FRAME_BUDGET = 2;
/** The time from when the worker is told of a move. */
const ANSWER_BUDGET = 7;
/** So many times so many moves, each made when the one before it is answered. */
const BATCHES = 9;
const MOVES = 8;

/** In the page: milliseconds of the same work, some times over. */
const otherWork = () =>
  Array.from({ length: 8 }, () => {
    const begun = performance.now();
    let sum = 0;
    for (let i = 1; i < 2_000_000; i++) sum += 1 / i;
    return sum > 0 ? performance.now() - begun : 0;
  });

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

test('a drag on 2500 vertices is answered quickly and costs the page less', async ({ page }) => {
  await page.addInitScript(() => {
    window.shapes = { shown: 0, answered: 0 };
    window.Worker = class extends Worker {
      constructor(...about) {
        super(...about);
        this.addEventListener('message', ({ data }) => {
          window.shapes.shown += Number(data.type === 'frame');
          window.shapes.answered += Number(Boolean(data.answers));
        });
      }
    };
  });
  await visit(page, `backend=webgl2#example=${EXAMPLE}`);
  await waitForState(page, (now) => now.vertices > 2400 && now.renderer === 'webgl2');
  const known = (await state(page)).handles.length;
  const vertex = await page.evaluate(() => {
    const { vertices, handles } = window.shapeUp.state();
    const held = new Set(handles.map((handle) => handle.vertex));
    const all = Array.from({ length: vertices }, (_, i) => (i + (vertices >> 1)) % vertices);
    return all.find((one) => !held.has(one) && window.shapeUp.screen(one));
  });
  const [x, y] = await screenOf(page, vertex);
  await page.mouse.dblclick(x, y);
  await waitForState(page, (now, before) => now.handles.length === before + 1, known);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  const spent = async () => {
    const { metrics } = await devtools.send('Performance.getMetrics');
    const named = Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
    const seconds = named.ScriptDuration + named.LayoutDuration + named.RecalcStyleDuration;
    return 1000 * seconds;
  };

  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 10, { steps: 4 });
  await waitForState(page, (now) => now.iteration > 0);
  // What Playwright itself does in the page would count: a batch of moves is one call.
  const showMoves = async ([left, top, count]) => {
    const view = document.querySelector('[role="application"]');
    const { shapes } = window;
    const before = shapes.shown;
    for (let i = 0; i < count; i++) {
      const [clientX, clientY] = [left + 3 * i, top - i];
      const where = { clientX, clientY, pointerId: 1, pointerType: 'mouse', buttons: 1 };
      const { answered } = shapes;
      view.dispatchEvent(new PointerEvent('pointermove', where));
      while (shapes.answered === answered) await new Promise(requestAnimationFrame);
    }
    return shapes.shown - before;
  };
  const perShape = [];
  const others = [];
  for (let batch = 0; batch < BATCHES; batch++) {
    const before = await spent();
    const shown = await page.evaluate(showMoves, [x, y - 12 - batch, MOVES]);
    perShape.push(((await spent()) - before) / shown);
    others.push(...(await page.evaluate(otherWork)));
  }
  await page.mouse.up();
  const { answer, latency } = await page.evaluate(() => window.shapeUp.dragTimes());
  const [work, answers, unit] = [perShape, answer, others].map(median);
  const said = `page ${work.toFixed(2)} ms, worker ${answers.toFixed(2)} ms, other work ${unit.toFixed(2)} ms, pointer to positions ${median(latency).toFixed(1)} ms`;
  test.info().annotations.push({ type: 'measured', description: said });
  expect(work, said).toBeLessThan(FRAME_BUDGET * unit);
  expect(answers, said).toBeLessThan(ANSWER_BUDGET * unit);
  // Told to whom asks for it.
  const told = page.getByTitle('Time from a pointer movement to new positions');
  await expect(told).toBeHidden();
  await showPanel(page, 'Energies and display');
  await page.getByLabel('Timings').check();
  await expect(told).toContainText('ms');
});
