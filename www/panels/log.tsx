/** The log: the messages since the page was opened. */

import '../ui/styles/lists.css';
import { useState } from 'preact/hooks';
import { useApp } from '../store/use-app.ts';
import { Button } from '../ui/components/buttons.tsx';
import { copyText } from '../ui/output.ts';
import type { Entry } from '../ui/controls/alerts.tsx';

const NAMES = { error: 'Error', notice: 'Notice', status: '' };

export function Log() {
  return (
    <>
      <Messages />
      <Copy />
    </>
  );
}

/** The messages, the latest first. */
function Messages() {
  const { alerts } = useApp();
  return (
    // Focusable, so that it can be scrolled by keyboard.
    <ol class="log" aria-label="Messages" tabIndex={0}>
      {alerts.journal.toReversed().map((entry) => (
        <Message key={entry.id} {...entry} />
      ))}
    </ol>
  );
}

const Message = ({ time, kind, text }: Entry) => (
  <li class={kind}>
    <time dateTime={time.toISOString()}>{time.toTimeString().slice(0, 8)}</time>
    <span>
      {NAMES[kind] && <strong>{NAMES[kind]}: </strong>}
      {text}
    </span>
  </li>
);

function Copy() {
  const { alerts } = useApp();
  const [result, setResult] = useState('');

  async function copy() {
    const lines = alerts.journal.map(
      ({ time, kind, text }) => `${time.toISOString()} ${NAMES[kind] && `${NAMES[kind]}: `}${text}`,
    );
    setResult(await copyText(`${lines.join('\n')}\n`, 'The browser did not allow copying.'));
  }

  return (
    <p class="log-end">
      <Button onClick={copy}>Copy as text</Button>
      <span class="quiet" aria-live="polite">
        {result}
      </span>
    </p>
  );
}
