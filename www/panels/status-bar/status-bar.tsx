/** The status bar: status message, hint, numbers of the iteration, and the environment. */

import { useEffect, useState } from 'preact/hooks';
import { colouring, movedInWords, toleranceOf, worstOf } from '../../store/colours/measures.ts';
import { useAnswerTo } from '../../store/use-answer.ts';
import { useApp } from '../../store/use-app.ts';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { duration, energyOrZero, groupDigits, measured, number } from '../../ui/words.ts';
import { drawsInSoftware } from '../../viewport/graphics-card.ts';
import { hintOf } from './hint.ts';
import type { ComponentChildren } from 'preact';
import type { State } from '../../store/state.ts';

const RENDERERS = { webgpu: 'WebGPU', webgl2: 'WebGL2', none: 'no 3D', starting: '' };
/** What there is room for in a wide window only. */
const WIDE = 'wide narrow-hidden';

/** The last event. */
export const Status = () => <>{useApp().store.state.status}</>;

/** What to do next. */
export function Hint() {
  const { state } = useApp().store;
  return <>{useThrottled(() => hintOf(state))}</>;
}

/** The numbers, and the environment. */
export function StatusNumbers() {
  const { document, model, display, renderer, saved } = useApp().store.state;
  return (
    <>
      {display.timings && (
        <>
          <Live name="iteration" look="narrow-hidden" read={iteration} />
          <Live name="energy" look={WIDE} read={energy} />
        </>
      )}
      <WorstPanel />
      <Live name="moved" look="narrow-hidden in-legend" read={movedInWords} />
      {display.timings && (
        <>
          <Live look="narrow-hidden" read={stepTime} />
          <Live
            name="drag"
            look="narrow-hidden"
            title="Time from a pointer movement to new positions"
            read={dragTime}
          />
        </>
      )}
      {document && model && (
        <Cell look={WIDE}>{`${document.units || 'no unit'} · ${document.up}-up`}</Cell>
      )}
      {/* Unsaved changes are shown on screens of any width. */}
      <Cell look={/^Saved/.test(saved) ? WIDE : ''}>{saved}</Cell>
      <Cell look={WIDE}>{display.timings && RENDERERS[renderer]}</Cell>
      <SoftwareRendering />
      <Offline />
    </>
  );
}

/** A value with its name; nothing without a value. */
function Cell(props: { name?: string; title?: string; look: string; children: ComponentChildren }) {
  const { name, title, look, children } = props;
  if (!children) return null;
  return (
    <div class={look} title={title}>
      {name && <dt>{name}</dt>}
      <dd>{children}</dd>
    </div>
  );
}

/** A cell that follows what changes with each frame. */
function Live({
  read,
  ...cell
}: {
  read: (state: Readonly<State>) => string | false | null;
  name?: string;
  title?: string;
  look: string;
}) {
  const { state } = useApp().store;
  return <Cell {...cell}>{useThrottled(() => read(state))}</Cell>;
}

const iteration = ({ numbers }: Readonly<State>) => numbers && groupDigits(numbers.iteration);
const energy = ({ numbers, model }: Readonly<State>) =>
  numbers && number(energyOrZero(numbers.energy.total, model?.size ?? 0));
const stepTime = ({ numbers }: Readonly<State>) =>
  numbers && numbers.stepMs > 0 && `${duration(numbers.stepMs)} per iteration`;
const dragTime = ({ dragMs }: Readonly<State>) => dragMs > 0 && duration(dragMs);

/** The greatest value of the measure that colours the faces, or would by default. */
function WorstPanel() {
  const { state } = useApp().store;
  const { model } = state;
  const about = colouring(state);
  const words = useThrottled(() => {
    const now = colouring(state);
    if (!now || !state.numbers) return '';
    const units = state.document?.units ?? '';
    return measured(worstOf(state, now.id), now.unit, units, toleranceOf(state, now));
  });
  if (!about || !model?.faces) return null;
  // The residual also applies to constraints that are not on panels.
  const what = about.signed ? 'greatest' : 'worst panel';
  return (
    <Cell
      name={about.id === 'residual' ? 'worst distance' : what}
      title={`${about.label}: ${about.words}`}
      look="in-legend"
    >
      {words}
    </Cell>
  );
}

const SLOW = 'Software rendering is slow. Turn on graphics acceleration in the browser settings.';

function SoftwareRendering() {
  const { renderer } = useApp().store.state;
  const { answer: isSlow } = useAnswerTo([renderer], () => drawsInSoftware(renderer));
  return (
    <Cell look={WIDE} title={SLOW}>
      {isSlow && 'Software rendering'}
    </Cell>
  );
}

/** Shows that the browser is offline, while it is. */
function Offline() {
  const { actions } = useApp();
  const [isOffline, setOffline] = useState(false);
  const kept = Boolean(navigator.serviceWorker?.controller);
  const words = `Offline: ${kept ? 'what you have used before still works' : 'what is loaded still works'}`;
  useEffect(() => {
    const update = () => setOffline(!navigator.onLine);
    window.addEventListener('online', update);
    window.addEventListener('offline', update);
    update();
    return () => {
      window.removeEventListener('online', update);
      window.removeEventListener('offline', update);
    };
  }, []);
  useEffect(() => {
    if (!isOffline) return undefined;
    actions.setStatus(words);
    return () => actions.setStatus('Online again');
  }, [isOffline]);
  return (
    <Cell look="" title={words}>
      {isOffline && 'Offline'}
    </Cell>
  );
}
