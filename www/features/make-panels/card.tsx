/**
 * The card over the view: the buttons that make all panels one shape, for a mesh just opened; then
 * the progress, and the verdict with ways to a better shape.
 */

import './make-panels.css';
import { useEffect, useRef } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { isLocked, panelsCard } from '../../store/panels-card.ts';
import { performNamed } from '../../store/perform.ts';
import { useApp } from '../../store/use-app.ts';
import { useForecastWords } from '../../store/use-forecast-words.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { byId } from '../../ui/dom.ts';
import { showElements } from '../../viewport/camera.ts';
import { useCover } from '../../viewport/use-cover.ts';
import { PanelButtons } from './buttons.tsx';
import { openEdit } from './edit-dialog.tsx';
import { makePanels } from './press.ts';
import { verdicts } from './verdicts.ts';
import type {
  ForecastWords,
  MeshSuggestion,
  BetterPress,
  PanelVerdict,
} from '../../pkg/engine/shape_up.js';
import { Sentence } from '../../ui/components/sentence.tsx';

/** How far the mesh will move for one shape of all panels, and what would reduce that. */
interface Forecast {
  /** null if there is none, undefined until it is known */
  found: ForecastWords | null | undefined;
  /** whether panels along the lines of curvature would help */
  newPanelsHelp: boolean;
  /** a simple change of the mesh that would reduce the move, unless new panels are the better choice */
  suggestion: MeshSuggestion | null;
}

/** @param isWanted whether it is shown */
function useForecast(isWanted: boolean): Forecast {
  const { model, document } = useApp().store.state;
  const found = useForecastWords(isWanted);
  const isFixed = isLocked({ document }, 'mesh');
  const newPanelsHelp = !isFixed && Boolean(model?.newPanels || found?.newPanels);
  const suggestion = !isFixed && !newPanelsHelp && found ? found.suggestion : null;
  return { found, newPanelsHelp, suggestion };
}

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
    byId('main').style.setProperty('--covered', covered ? `${covered}px` : ''),
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
        recommended={found?.recommended}
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
        before={<NewPanelsButton hidden={!forecast.newPanelsHelp} />}
      >
        <SuggestionButton forecast={forecast} />
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
  return (
    <Card class={isNotGood ? 'card warning' : 'card'} data-shows="verdict" data-level={level}>
      <p aria-live={verdict ? 'polite' : 'off'}>
        <Sentence words={words} />{' '}
        <span class="numbers">
          <Sentence words={numbers} />
        </span>
      </p>
      <button ref={hold} type="button" class="bordered">
        Hold to see the original
      </button>
      <CloseCard />
      {verdict && <Changes verdict={verdict} forecast={forecast} />}
      {children}
    </Card>
  );
}

/** Ways to a better shape, if the verdict asks for any. */
function Changes({ verdict, forecast }: { verdict: PanelVerdict; forecast: Forecast }) {
  const app = useApp();
  const { store, actions } = app;
  const isLooking = verdicts(app).isLooking.value;
  const presses = store.state.verdict?.report.suggestions ?? [];
  const isFixed = isLocked(store.state, 'constraints');
  const isNotGood = verdict.level !== 'good';
  const again = isFixed ? null : verdict.again;
  const isSearched = !isFixed && (isLooking || presses.length > 0);
  const helps = forecast.newPanelsHelp || forecast.suggestion !== null;
  const changesMesh = !isFixed && isNotGood && helps;
  if (!verdict.folded && again === null && !isSearched && !changesMesh) return null;

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
        <Button onClick={() => actions.begin(showFolds())}>Show the folds</Button>
      )}
      {again !== null && <Button onClick={makeAgain}>{again}</Button>}
      {isSearched && (
        <div class="better" role="group" aria-label="Suggestions">
          {presses.map((press) => (
            <Button
              key={press.id}
              class={press.recommended ? 'bordered recommended' : 'bordered'}
              onClick={() => choose(press)}
            >
              <Sentence words={`${press.label}: ${press.words}`} />
            </Button>
          ))}
          {isLooking && <p class="quiet">Looking for suggestions …</p>}
        </div>
      )}
      {changesMesh && <NewPanelsButton hidden={!forecast.newPanelsHelp} />}
      {changesMesh && <SuggestionButton forecast={forecast} />}
    </div>
  );
}

/** Lays out panels along the lines of curvature, on the original shape. */
function NewPanelsButton({ hidden }: { hidden: boolean }) {
  const { store, actions } = useApp();
  async function layOut() {
    if (store.get().document?.constraints.length) await actions.reset();
    actions.look({ corner: 'new-panels' });
  }
  return (
    <Button
      class="bordered suggestion"
      hidden={hidden}
      onClick={() => actions.reportErrors(layOut())}
    >
      New panels along the curvature
    </Button>
  );
}

/** Opens the operation that reduces the move, on the original shape. */
function SuggestionButton({ forecast: { suggestion } }: { forecast: Forecast }) {
  const app = useApp();
  const { store, actions } = app;
  async function apply() {
    if (!suggestion) return;
    if (store.get().document?.constraints.length) await actions.reset();
    await openEdit(app, suggestion.operation);
  }
  return (
    <Button
      class="bordered suggestion"
      aria-haspopup="dialog"
      hidden={!suggestion}
      onClick={() => actions.reportErrors(apply())}
    >
      {suggestion?.label}
    </Button>
  );
}

function CloseCard() {
  const { actions } = useApp();
  return <CloseButton label="Close" onClick={() => actions.closePanelsCard()} />;
}
