/**
 * The menu of the view: directions, projection, what is drawn besides the model, and the views that the
 * user has kept.
 */

import { createRef } from 'preact';
import { CommandButton } from '../../store/command-button.tsx';
import { useApp } from '../../store/use-app.ts';
import { MOUSE_SETTINGS } from '../../store/state.ts';
import { CloseButton, Key } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { Menu } from '../../ui/components/menu.tsx';
import { MOUSE_NAMES } from '../../viewport/input/mouse.ts';
import { byId } from '../../ui/dom.ts';
import { workingKeys } from '../../ui/keys.ts';
import { fly } from '../../viewport/camera.ts';
import type { State } from '../../store/state.ts';

const menu = createRef<HTMLDivElement>();

export function ViewMenu() {
  const { commands } = useApp();
  const sides = commands.flatMap(({ id }) => /^view-(.*)/.exec(id)?.slice(1) ?? []);
  return (
    <Menu
      of={menu}
      anchor={() => byId('view-menu-button')}
      id="view-menu"
      role="dialog"
      aria-label="Views"
    >
      <div class="view-cross" role="group" aria-label="Look from">
        {sides.map((name) => (
          <Item key={name} id={`view-${name}`} label={name[0].toUpperCase() + name.slice(1)} />
        ))}
      </div>
      <Item id="parallel" label="Parallel projection" />
      <Item id="ghost" label="Ghost of the original" />
      <Item id="ground" label="Ground grid" />
      <Item id="tape" label="Measure a distance" closes />
      <Item id="section" label="Section plane" />
      <Item id="turn-slowly" label="Turn slowly" closes />
      <Item id="theme" label="Light or dark" />
      <MouseChoice />
      <KeptViews />
    </Menu>
  );
}

/** The button of a command. */
function Item({ id, label, closes = false }: { id: string; label: string; closes?: boolean }) {
  const { keys = [], pressed } = useApp().commands.find((known) => known.id === id) ?? {};
  return (
    <CommandButton
      of={id}
      class={id}
      title={workingKeys(...keys).join(', ')}
      onClick={() => closes && menu.current?.hidePopover()}
    >
      {label}
      {pressed && <Key of={keys} />}
    </CommandButton>
  );
}

/** Whose mouse buttons move the camera. */
function MouseChoice() {
  const { store, actions } = useApp();
  return (
    <div class="field-row">
      <label for="mouse">Mouse as</label>
      <Choice
        id="mouse"
        value={store.state.mouse}
        options={MOUSE_SETTINGS.map((mouse) => [mouse, MOUSE_NAMES[mouse]] as const)}
        onChoose={(mouse) => actions.chooseMouse(mouse as State['mouse'])}
      />
    </div>
  );
}

/** The views that the user has kept: the camera of each, saved with the model. */
function KeptViews() {
  const { store, actions, viewport } = useApp();
  const { views } = store.state;

  function show({ name, camera, parallel }: State['views'][number]) {
    actions.look({ parallel, status: name });
    fly(viewport, (view) => view.placeCamera(Float64Array.from(camera)));
  }

  return (
    <div class="kept-views" role="group" aria-label="Kept views">
      <CommandButton of="keep-view" class="">
        Keep this view
      </CommandButton>
      <ul>
        {views.map((kept) => (
          <li key={kept.name}>
            <button type="button" onClick={() => show(kept)}>
              {kept.name}
            </button>
            <CloseButton
              label={`Remove ${kept.name}`}
              onClick={() => actions.look({ views: views.filter((view) => view !== kept) })}
            />
          </li>
        ))}
      </ul>
    </div>
  );
}
