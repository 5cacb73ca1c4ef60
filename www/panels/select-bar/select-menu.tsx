/**
 * The menu of selection operations: the declared operations by group, then sets and groups by name.
 * An operation with parameters replaces the menu by its form.
 */

import { Fragment } from 'preact';
import { useRef, useState } from 'preact/hooks';
import { combineOf, sizeOfSelection } from '../../store/selection.ts';
import { useApp } from '../../store/use-app.ts';
import { CloseButton, Key } from '../../ui/components/buttons.tsx';
import { Menu } from '../../ui/components/menu.tsx';
import { count } from '../../ui/words.ts';
import { opener } from './select-bar.tsx';
import { Heading, OperationForm, SaveForm } from './select-forms.tsx';
import type { Operation } from '../../pkg/engine/shape_up.js';

export function SelectMenu() {
  const menu = useRef<HTMLDivElement>(null);
  const [isOpen, setOpen] = useState(false);
  return (
    <Menu
      of={menu}
      anchor={() => opener.current!}
      id="select-menu"
      role="dialog"
      aria-label="Select"
      onBeforeToggle={({ newState }) => newState === 'open' && setOpen(true)}
      // Not before it is closed: what has the focus in it gives that back.
      onToggle={({ newState }) => newState === 'closed' && setOpen(false)}
    >
      {isOpen && <Content close={() => menu.current?.hidePopover()} />}
    </Menu>
  );
}

function Content({ close }: { close: () => void }) {
  const [asked, setAsked] = useState<Operation | 'save' | null>(null);
  if (asked === 'save') return <SaveForm close={close} />;
  if (asked) return <OperationForm operation={asked} close={close} />;
  return (
    <>
      <Operations close={close} ask={setAsked} />
      <Named close={close} save={() => setAsked('save')} />
    </>
  );
}

/** Operations that start from the selection replace it. */
function combineWith(operation: Operation, event: MouseEvent, adds: boolean) {
  return operation.needsSelection ? 'replace' : combineOf(event, adds);
}

/** The operations for what a click selects. */
function Operations(props: { close: () => void; ask: (operation: Operation) => void }) {
  const { store, selecting } = useApp();
  const { operations, mode, adds } = store.state;
  const fitting = operations.filter(({ modes, takesName }) => modes.includes(mode) && !takesName);
  const groups = [...new Set(fitting.map(({ group }) => group))];

  function apply(operation: Operation, event: MouseEvent) {
    if (operation.params.length > 0) return props.ask(operation);
    props.close();
    void selecting.applyOrReport(operation, { combine: combineWith(operation, event, adds) });
  }

  return (
    <>
      {groups.map((group) => (
        <Fragment key={group}>
          <Heading>{group}</Heading>
          {fitting
            .filter((operation) => operation.group === group)
            .map((operation) => (
              <button
                key={operation.id}
                type="button"
                title={operation.summary}
                disabled={!selecting.canApply(operation)}
                onClick={(event) => apply(operation, event)}
              >
                <span>
                  {operation.label}
                  {operation.params.length > 0 && '…'}
                </span>
                <Key of={operation.keys} />
              </button>
            ))}
        </Fragment>
      ))}
    </>
  );
}

/** The sets of the scene and the groups of the file. */
function Named({ close, save }: { close: () => void; save: () => void }) {
  const { store, actions, selecting } = useApp();
  const { operations, selection, document, model, adds } = store.state;
  const operation = operations.find(({ takesName }) => takesName);
  if (!operation) return null;
  const pick = (name: string) => (event: MouseEvent) => {
    close();
    const combine = combineWith(operation, event, adds);
    void selecting.applyOrReport(operation, { params: { name }, combine });
  };
  return (
    <>
      <Heading>Sets and groups</Heading>
      <button type="button" disabled={sizeOfSelection(selection) === 0} onClick={save}>
        <span>Save as a set…</span>
      </button>
      {document?.sets.map(({ name, vertices, faces }) => (
        <div key={name} class="set">
          <button type="button" onClick={pick(name)}>
            <span>{name}</span>
            <span class="quiet">
              {faces > 0 ? count(faces, 'face') : count(vertices, 'vertex', 'vertices')}
            </span>
          </button>
          <CloseButton
            label={`Remove set ${name}`}
            title="Remove"
            onClick={() => {
              close();
              void actions.edit({ removeSet: { name } });
            }}
          />
        </div>
      ))}
      {model?.groups.map(({ name, faces }) => (
        <button key={name} type="button" onClick={pick(name)}>
          <span>{name}</span>
          <span class="quiet">{count(faces, 'face')}</span>
        </button>
      ))}
    </>
  );
}
