/** The components of the page, each in its place of `index.html`, which is there before them. */

import { render, type ComponentType, type ContainerNode } from 'preact';
import { FirstHints } from '../features/hints.tsx';
import { Colours } from '../panels/colours/colours.tsx';
import { Shown } from '../panels/colours/shown.tsx';
import { Constraints } from '../panels/constraints/constraints.tsx';
import { Energies } from '../panels/energies/energies.tsx';
import { Handles } from '../panels/handles/handles.tsx';
import { ExampleNote } from '../panels/example.tsx';
import { Legend } from '../panels/legend/legend.tsx';
import { Model } from '../panels/model/model.tsx';
import { SelectBar } from '../panels/select-bar/select-bar.tsx';
import { SelectMenu } from '../panels/select-bar/select-menu.tsx';
import { Hint, Status, StatusNumbers } from '../panels/status-bar/status-bar.tsx';
import { MoveFact, ShapeFact } from '../panels/step-facts.tsx';
import { AppProvider } from '../store/use-app.ts';
import { byId } from '../ui/dom.ts';
import { Analysis } from './analysis.tsx';
import type { AppContext } from './context.ts';

/** The components inside a place, by its id. */
const INSIDE: Record<string, ComponentType> = {
  'fact-shape': ShapeFact,
  'fact-move': MoveFact,
  model: Model,
  constraints: Constraints,
  energies: Energies,
  handles: Handles,
  colours: Colours,
  display: Shown,
  analysis: Analysis,
  status: Status,
  hint: Hint,
  numbers: StatusNumbers,
  hints: FirstHints,
};

/** The components that are a place, by its id: whether it is hidden is up to them. */
const WHOLE: Record<string, ComponentType> = {
  'example-note': ExampleNote,
  legend: Legend,
  'select-bar': SelectBar,
  'select-menu': SelectMenu,
};

export function renderPage(app: AppContext) {
  const show = (Component: ComponentType, into: ContainerNode) =>
    render(
      <AppProvider value={app}>
        <Component />
      </AppProvider>,
      into,
    );
  for (const [id, Component] of Object.entries(INSIDE)) show(Component, byId(id));
  for (const [id, Component] of Object.entries(WHOLE)) show(Component, around(byId(id)));
}

/** What has only one element of its parent: a component is rendered to it, and the others stay. */
function around(place: HTMLElement): ContainerNode {
  const parent = place.parentNode!;
  return {
    nodeType: Node.ELEMENT_NODE,
    parentNode: parent,
    firstChild: place,
    childNodes: [place],
    insertBefore: (node, before) => parent.insertBefore(node as Node, before as Node | null),
    appendChild: (node) => parent.appendChild(node as Node),
    removeChild: (node) => parent.removeChild(node as Node),
  };
}
