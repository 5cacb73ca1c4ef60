/**
 * The card over the view: the buttons that make all panels one shape, for a mesh just opened; then
 * the progress, and the verdict with ways to a better shape.
 */

import './make-panels.css';
import { useEffect, useRef } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { nextStep } from '../../store/next-step.ts';
import { isLocked, panelsCard } from '../../store/panels-card.ts';
import { performNamed } from '../../store/perform.ts';
import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { showElements } from '../../viewport/camera.ts';
import { useCover } from '../../viewport/use-cover.ts';
import { PanelButtons } from './buttons.tsx';
import { NewPanelsButton, SuggestionButton, useForecast, type Forecast } from './forecast.tsx';
import { makePanels } from './press.ts';
import { verdicts } from './verdicts.ts';
import type { AppContext } from '../../app/context.ts';
import type { BetterPress, PanelVerdict } from '../../pkg/engine/shape_up.js';
import { Sentence } from '../../ui/components/sentence.tsx';

/** @param children what is said below the verdict */
export function PanelsCard({ children }: { children?: ComponentChildren }) {
  const app = useApp();
  const { state } = app.store;
  // The verdict follows the shape also where there is no room for the card.
  verdicts(app);
  const shows = panelsCard(state);
  const forecast = useForecast(shows === 'offer');
  if (shows === 'offer') return <Offer forecast={forecast} />;
  return shows === 'verdict' ? <Outcome forecast={forecast}>{children}</Outcome> : null;
}

/** The card; the model is framed in the area above it. */
function Card({
  children,
  ...rest
}: {
  'data-shows': string;
  'data-level'?: string;
  class: string;
  children: ComponentChildren;
}) {
  const place = useCover<HTMLDivElement>('bottom', (covered) =>
    document.documentElement.style.setProperty('--covered', covered ? `${covered}px` : ''),
  );
  return (
    <div id="make-panels-card" ref={place} role="group" aria-label="Panels" {...rest}>
      {children}
    </div>
  );
}

/** The buttons, and how far the mesh will move. */
function Offer({ forecast }: { forecast: Forecast }) {
  const app = useApp();
  const { found } = forecast;
  return (
    <Card class="card" data-shows="offer">
      <PanelButtons
        forecast={forecast}
        changesMesh
        between={
          // It has its place at once: a card that grows moves the model, and what the user does with it.
          <p class="quiet forecast" hidden={found === null}>
            {found === undefined ? (
              'Estimating how far the mesh will move …'
            ) : (
              <Sentence words={found?.words ?? ''} />
            )}
          </p>
        }
      >
        <button
          type="button"
          aria-haspopup="dialog"
          onClick={() => performNamed('add-constraint', app)}
        >
          Something else
        </button>
      </PanelButtons>
      <CloseCard />
    </Card>
  );
}

/** Progress during a run, and the verdict after it with ways to a better shape. */
function Outcome({ forecast, children }: { forecast: Forecast; children: ComponentChildren }) {
  const app = useApp();
  const hold = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (hold.current) app.hold.bind(hold.current);
  }, [app]);
  const { words, numbers, verdict } = verdicts(app).said.value;
  const level = verdict?.level ?? '';
  const isNotGood = verdict !== null && level !== 'good';
  const ways = verdict && waysTo(app, verdict, forecast);
  const isNext = ways !== null && !ways.next && nextStep(app.store.state) === 'choose';
  return (
    <Card class={isNotGood ? 'card warning' : 'card'} data-shows="verdict" data-level={level}>
      <p aria-live={verdict ? 'polite' : 'off'}>
        <Sentence words={words} />{' '}
        <span class="numbers">
          <Sentence words={numbers} />
        </span>
      </p>
      <button ref={hold} type="button" class={classOf(isNext)}>
        Hold to see the original
      </button>
      <CloseCard />
      {verdict && ways?.isAny && <Changes verdict={verdict} forecast={forecast} ways={ways} />}
      {children}
    </Card>
  );
}

/** The ways to a better shape that a verdict asks for, and which of them is the next step. */
function waysTo(app: AppContext, verdict: PanelVerdict, forecast: Forecast) {
  const { state } = app.store;
  const isLooking = verdicts(app).isLooking.value;
  const presses = state.verdict?.report.suggestions ?? [];
  const isFixed = isLocked(state, 'constraints');
  const again = isFixed ? null : verdict.again;
  const isSearched = !isFixed && (isLooking || presses.length > 0);
  const helps = forecast.newPanelsHelp || forecast.suggestion !== null;
  const changesMesh = !isFixed && verdict.level !== 'good' && helps;
  const press = isFixed ? undefined : presses.find(({ recommended }) => recommended);
  const inTurn = { again: again !== null, press, mesh: changesMesh, folds: verdict.folded > 0 };
  const possible = (Object.keys(inTurn) as (keyof typeof inTurn)[]).find((way) => inTurn[way]);
  const next = nextStep(state) === 'choose' ? possible : undefined;
  const isAny = possible !== undefined || isSearched;
  return { isLooking, presses, again, isSearched, changesMesh, next, isAny };
}

/** Ways to a better shape. */
function Changes({
  verdict,
  forecast,
  ways: { isLooking, presses, again, isSearched, changesMesh, next },
}: {
  verdict: PanelVerdict;
  forecast: Forecast;
  ways: ReturnType<typeof waysTo>;
}) {
  const app = useApp();
  const { store, actions } = app;
  const kindOf = (id: string) => store.get().kinds.find((kind) => kind.id === id);
  /** Makes the panels again from the original, within the tolerance that is shown. */
  function makeAgain() {
    const kind = kindOf(verdict.kind);
    return kind && makePanels(app, kind, { from: 'original' });
  }
  function choose({ kind: id, within, from, label }: BetterPress) {
    const kind = kindOf(id);
    return kind && makePanels(app, kind, { from, within, label });
  }
  async function showFolds() {
    const found = await actions.reportErrors(actions.ask.flawed('folded-faces'));
    if (found) showElements(app, found);
  }

  return (
    <div class="changes">
      {verdict.folded > 0 && (
        <Button class={classOf(next === 'folds')} onClick={() => actions.begin(showFolds())}>
          Show the folds
        </Button>
      )}
      {again !== null && (
        <Button class={classOf(next === 'again')} onClick={makeAgain}>
          {again}
        </Button>
      )}
      {isSearched && (
        <div class="better" role="group" aria-label="Suggestions">
          {presses.map((press) => (
            <Button
              key={press.id}
              class={classOf(next === 'press' && press.recommended)}
              onClick={() => choose(press)}
            >
              <Sentence words={`${press.label}: ${press.words}`} />
            </Button>
          ))}
          {isLooking && <p class="quiet">Looking for suggestions …</p>}
        </div>
      )}
      {changesMesh && (
        <>
          <NewPanelsButton isShown={forecast.newPanelsHelp} isNext={next === 'mesh'} />
          <SuggestionButton suggestion={forecast.suggestion} isNext={next === 'mesh'} />
        </>
      )}
    </div>
  );
}

const classOf = (isNext: boolean) => (isNext ? 'bordered next' : 'bordered');

function CloseCard() {
  const { actions } = useApp();
  return <CloseButton label="Close" onClick={() => actions.closePanelsCard()} />;
}
