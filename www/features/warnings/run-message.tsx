/** The message on the last run, among the messages or on the card of the panels. */

import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { byId } from '../../ui/dom.ts';
import { useCover, useNarrow } from '../../viewport/use-cover.ts';
import { nextStep } from '../../store/next-step.ts';
import { panelsCard } from '../../store/panels-card.ts';
import { conditions } from './conditions.ts';
import type { Message } from './run-messages.ts';
import { Sentence } from '../../ui/components/sentence.tsx';

/** @param isOnCard whether this is its place on the card of the panels, which it has where that is shown */
export function RunMessage({ isOnCard = false }) {
  const app = useApp();
  const message = conditions(app).messages.now.value;
  const hasCard = panelsCard(app.store.state) === 'verdict';
  if (!message || isOnCard !== hasCard) return null;
  const { words, offers = [], isOpen, wasOnCard } = message;
  // Good news that has been read leaves the smaller view beside a docked panel to the model.
  if (!isOnCard) return wasOnCard && !isOpen ? null : <Notice message={message} />;
  return words || offers.length > 0 ? (
    <div class="suggestions" role="group" aria-label="Verdict">
      <Content message={{ ...message, result: '' }} />
    </div>
  ) : null;
}

function Notice({ message }: { message: Message }) {
  const app = useApp();
  const { messages } = conditions(app);
  // The model is framed beside a verdict; other messages move no camera.
  const place = useCover<HTMLDivElement>(
    useNarrow() ? 'bottom' : 'top',
    () => {},
    () => byId('messages'),
  );
  return (
    <div ref={place} class="suggestions message notice" role="group" aria-label="Verdict">
      <Content message={message} isNext={nextStep(app.store.state) === 'choose'} />
      <CloseButton label="Dismiss the verdict" onClick={() => messages.withdraw()} />
    </div>
  );
}

/** @param props.isNext whether one of its offers is the next step */
function Content({
  message: { result = '', words, numbers, offers = [], waits },
  isNext = false,
}: {
  message: Message;
  isNext?: boolean;
}) {
  const { messages } = conditions(useApp());
  const next = isNext ? (offers.find(({ changes }) => changes) ?? offers.at(0)) : undefined;
  return (
    <>
      <p>
        <Sentence words={`${result} ${words}`.trim()} />
        {numbers && (
          <span class={numbers.elsewhere}>
            {' '}
            <Sentence words={numbers.words} />
          </span>
        )}
      </p>
      {offers.map((offer) => (
        <Button
          key={offer.label}
          class={offer === next ? 'small bordered next' : 'small bordered'}
          title={offer.title}
          onClick={() => {
            if (!offer.stays) messages.withdraw();
            offer.act();
          }}
        >
          {offer.label}
        </Button>
      ))}
      {waits && <p class="quiet">{waits}</p>}
    </>
  );
}
