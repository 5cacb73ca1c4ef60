/** The command palette: every command by name, with its key. */

import './palette.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import { isEnabled, perform } from '../../store/perform.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Key } from '../../ui/components/buttons.tsx';
import type { State } from '../../store/state.ts';
import type { AppContext, Command } from '../../app/context.ts';

export function openPalette(app: AppContext) {
  showDialog(app, { id: 'palette', title: 'Commands', light: true, lasts: true }, Palette);
}

/** What a command is called in the list. */
const nameOf = ({ label, group }: Command) => `${label} ${group}`.toLowerCase();

/** The commands that have all words, those whose name begins with the first one first. */
function found(commands: Command[], asked: string) {
  const words = asked.toLowerCase().split(/\s+/).filter(Boolean);
  const fitting = commands.filter((one) => words.every((word) => nameOf(one).includes(word)));
  const begins = (one: Command) => nameOf(one).startsWith(words[0] ?? '');
  return [...fitting.filter(begins), ...fitting.filter((one) => !begins(one))];
}

function Palette({ close }: InDialog) {
  const { store, commands } = useApp();
  const [asked, setAsked] = useState('');
  const [at, setAt] = useState(0);
  const chosen = useRef<HTMLLIElement>(null);
  useEffect(() => chosen.current?.scrollIntoView({ block: 'nearest' }), [at, asked]);

  const state = store.state as State;
  const rows = found(
    commands.filter((one) => !one.unlisted && (one.needsModel ? state.document : true)),
    asked,
  );
  const enter = (command: Command | undefined) => {
    if (!command || !isEnabled(command, state)) return;
    close();
    perform(command, store);
  };
  const moves: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 };

  return (
    <>
      <input
        autofocus
        type="text"
        role="combobox"
        aria-label="Command"
        aria-expanded="true"
        aria-controls="palette-list"
        aria-activedescendant={rows[at] && `palette-${rows[at].id}`}
        aria-autocomplete="list"
        placeholder="Type what you want to do"
        autocomplete="off"
        spellcheck={false}
        value={asked}
        onInput={({ currentTarget }) => {
          setAsked(currentTarget.value);
          setAt(0);
        }}
        onKeyDown={(event) => {
          const by = moves[event.key];
          if (event.key === 'Enter') enter(rows[at]);
          else if (by) setAt(Math.max(0, Math.min(at + by, rows.length - 1)));
          else return;
          event.preventDefault();
        }}
      />
      <ul id="palette-list" role="listbox" aria-label="Commands">
        {rows.map((command, i) => (
          <li
            key={command.id}
            id={`palette-${command.id}`}
            ref={i === at ? chosen : null}
            role="option"
            aria-selected={i === at}
            aria-disabled={!isEnabled(command, state)}
            onPointerMove={() => setAt(i)}
            onClick={() => enter(command)}
          >
            <span>{command.label}</span>
            <span class="quiet">{command.group}</span>
            <Key of={command.keys} />
          </li>
        ))}
      </ul>
      {rows.length === 0 && (
        <p class="quiet" role="status">
          Nothing is called “{asked}”.
        </p>
      )}
    </>
  );
}
