/** The components of the page, each in its place of `index.html`, which is there before them. */

import { render, type ComponentType } from 'preact';
import { BuildPanel } from '../features/build/build-panel.tsx';
import { Curvature } from '../features/curvature/curvature-card.tsx';
import { FlatMapPanel } from '../features/flat-map/flat-map-panel.tsx';
import { FlatMapRegion } from '../features/flat-map/flat-map-region.tsx';
import { MeshTools, PanelsInStep } from '../features/make-panels/buttons.tsx';
import { PanelsCard } from '../features/make-panels/card.tsx';
import { NewPanels } from '../features/make-panels/new-panels.tsx';
import { VariationsButton, VariationsPanel } from '../features/variations/variations-panel.tsx';
import { ViewMenu } from '../features/view-tools/view-menu.tsx';
import { RunMessageOnCard } from '../features/warnings/run-message.tsx';
import { Warnings } from '../features/warnings/warnings.tsx';
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
import { ModelFact, MoveFact, ShapeFact } from '../panels/step-facts.tsx';
import { AppProvider } from '../store/use-app.ts';
import { byId } from '../ui/dom.ts';
import { Analysis } from './analysis.tsx';
import type { AppContext } from './context.ts';

/** The components, by the id of their place. */
const PLACES: Record<string, ComponentType> = {
  'fact-open': ModelFact,
  'fact-shape': ShapeFact,
  'fact-move': MoveFact,
  'mesh-tools': MeshTools,
  'make-panels-place': PanelsInStep,
  'panels-card-place': () => (
    <PanelsCard>
      <RunMessageOnCard />
    </PanelsCard>
  ),
  'more-messages': Warnings,
  'move-tools': VariationsButton,
  corner: () => (
    <>
      <NewPanels />
      <Curvature />
    </>
  ),
  'docked-place': () => (
    <>
      <VariationsPanel />
      <BuildPanel />
    </>
  ),
  'flat-map-panel-place': FlatMapPanel,
  'flat-map-place': FlatMapRegion,
  'view-menu': ViewMenu,
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
  'example-place': ExampleNote,
  'legend-place': Legend,
  'select-bar-place': SelectBar,
  'select-menu-place': SelectMenu,
};

export function renderPage(app: AppContext) {
  for (const [id, Component] of Object.entries(PLACES))
    render(
      <AppProvider value={app}>
        <Component />
      </AppProvider>,
      byId(id),
    );
}
