/** The message on the last run, among the messages or on the card of the panels. */

import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { byId } from '../../ui/dom.ts';
import { useCover, useNarrow } from '../../viewport/use-cover.ts';
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
  const { messages } = conditions(useApp());
  // The model is framed beside a verdict; other messages move no camera.
  const place = useCover<HTMLDivElement>(
    useNarrow() ? 'bottom' : 'top',
    () => {},
    () => byId('messages'),
  );
  return (
    <div ref={place} class="suggestions message notice" role="group" aria-label="Verdict">
      <Content message={message} />
      <CloseButton label="Dismiss the verdict" onClick={() => messages.withdraw()} />
    </div>
  );
}

function Content({
  message: { result = '', words, numbers, offers = [], waits },
}: {
  message: Message;
}) {
  const { messages } = conditions(useApp());
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
      {offers.map(({ label, title, stays, act }) => (
        <Button
          key={label}
          class="small bordered"
          title={title}
          onClick={() => {
            if (!stays) messages.withdraw();
            act();
          }}
        >
          {label}
        </Button>
      ))}
      {waits && <p class="quiet">{waits}</p>}
    </>
  );
}
