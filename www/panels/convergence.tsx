/**
 * The energies of the iterations since the model was opened or reset, plotted while visible. The
 * plotting library is loaded with the first iteration, not with the page.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { useAnswer } from '../store/use-answer.ts';
import { useApp } from '../store/use-app.ts';
import { messageOf } from '../solver/errors.ts';
import { columnsOf, TRACE_WIDTH } from '../ui/plot/energies.ts';
import type { EnergyPlot } from '../ui/plot/plot.ts';

/**
 * The least interval between redraws: a plot of thousands of iterations takes some milliseconds.
 */
const PLOT_EVERY_MS = 250;

export function Convergence() {
  const { store, actions } = useApp();
  const place = useRef<HTMLDivElement>(null);
  const trace = useAnswer(
    place,
    PLOT_EVERY_MS,
    () => store.state.numbers,
    // A stopped solver reports its own error.
    () => actions.ask.trace().catch(() => undefined),
  );
  const isDrawn = trace && trace.length >= 2 * TRACE_WIDTH;
  return (
    <div ref={place}>
      {isDrawn ? (
        <Curves trace={trace} />
      ) : (
        <p class="quiet">The energies of each iteration appear here.</p>
      )}
    </div>
  );
}

function Curves({ trace }: { trace: Float64Array }) {
  const { document, model, dark } = useApp().store.state;
  const place = useRef<HTMLDivElement>(null);
  const [plot, setPlot] = useState<EnergyPlot | null>(null);
  const [problem, setProblem] = useState('');

  useEffect(() => {
    let made: EnergyPlot | null = null;
    let isGone = false;
    async function load() {
      const { EnergyPlot } = await import('../ui/plot/plot.ts');
      if (isGone || !place.current) return;
      made = new EnergyPlot(place.current);
      setPlot(made);
    }
    load().catch((error) => setProblem(messageOf(error)));
    return () => {
      isGone = true;
      made?.destroy();
    };
  }, []);
  useEffect(
    () =>
      plot?.show(columnsOf(trace, model?.size ?? 0), document?.units ? `${document.units}²` : ''),
    [plot, trace],
  );
  useEffect(() => plot?.restyle(), [dark]);

  return <div ref={place}>{problem && <p>The plot could not be loaded: {problem}</p>}</div>;
}
