/** The menu of the examples, with pictures. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { performNamed } from '../store/perform.ts';
import { useApp } from '../store/use-app.ts';
import { Entry, Menu } from '../ui/components/menu.tsx';
import { byId } from '../ui/dom.ts';
import type { Example } from '../solver/examples.ts';

export function ExamplesMenu() {
  const app = useApp();
  const { files, actions } = app;
  const menu = useRef<HTMLDivElement>(null);
  const [examples, setExamples] = useState<Example[]>([]);
  const fill = () => actions.reportErrors(files.examples().then(setExamples));
  useEffect(() => void fill(), []);
  const choose = (action: () => unknown) => () => {
    menu.current?.hidePopover();
    action();
  };
  return (
    <Menu
      of={menu}
      anchor={() => byId('examples-button')}
      id="examples"
      role="menu"
      aria-label="Examples"
      onBeforeToggle={({ newState }) => {
        // They could not be fetched before.
        if (newState === 'open' && examples.length === 0) void fill();
      }}
    >
      <button
        type="button"
        class="new-mesh"
        role="menuitem"
        aria-haspopup="dialog"
        onClick={choose(() => performNamed('new-mesh', app))}
      >
        <Entry title="New mesh">
          A grid, a vault, a dome, hexagons and others, in sizes of your choice.
        </Entry>
      </button>
      <a role="menuitem" href="./gallery.html">
        <Entry title="Gallery">All examples with pictures of their start and end.</Entry>
      </a>
      {examples.map((example) => (
        <button
          key={example.id}
          type="button"
          role="menuitem"
          onClick={choose(() => actions.reportErrors(files.openExample(example)))}
        >
          {/* Loaded when the menu opens; without a network, only if the gallery has shown it. */}
          <img
            loading="lazy"
            src={`pictures/${example.id}-end.webp`}
            alt=""
            width={72}
            height={52}
            onError={({ currentTarget }) => (currentTarget.hidden = true)}
          />
          <Entry title={example.title}>{example.summary}</Entry>
        </button>
      ))}
    </Menu>
  );
}
