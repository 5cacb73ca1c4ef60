/** The components of the page, each in its place of `index.html`, which is there before them. */

import { render, type ComponentChildren, type ComponentType } from 'preact';
import { RecentMenu } from '../documents/recent-menu.tsx';
import { BuildPanel } from '../features/build/build-panel.tsx';
import { Curvature } from '../features/curvature/curvature-card.tsx';
import { EmbeddedView } from '../features/embed/embedded-view.tsx';
import { FlatMapPanel } from '../features/flat-map/flat-map-panel.tsx';
import { FlatMapRegion } from '../features/flat-map/flat-map-region.tsx';
import { Lesson, LessonCard, lockable } from '../features/lesson/panel.tsx';
import { MeshTools, PanelsInStep } from '../features/make-panels/buttons.tsx';
import { PanelsCard } from '../features/make-panels/card.tsx';
import { makePanels } from '../features/make-panels/press.ts';
import { NewPanels } from '../features/make-panels/new-panels.tsx';
import { Stage } from '../features/present/stage.tsx';
import { VariationsButton, VariationsPanel } from '../features/variations/variations-panel.tsx';
import { SectionCard } from '../features/view-tools/section-card.tsx';
import { ViewMenu } from '../features/view-tools/view-menu.tsx';
import { RunMessage } from '../features/warnings/run-message.tsx';
import { Warnings } from '../features/warnings/warnings.tsx';
import { FirstHints } from '../features/hints.tsx';
import { Colours } from '../panels/colours/colours.tsx';
import { Compare } from '../panels/colours/compare.tsx';
import { Shown } from '../panels/colours/shown.tsx';
import { Constraints } from '../panels/constraints/constraints.tsx';
import { Energies } from '../panels/energies/energies.tsx';
import { HalfStepSwitch } from '../panels/energies/half-step-switch.tsx';
import { Handles } from '../panels/handles/handles.tsx';
import { ExampleNote } from '../panels/example.tsx';
import { Legend } from '../panels/legend/legend.tsx';
import { ImportReport, Model } from '../panels/model/model.tsx';
import { SelectBar } from '../panels/select-bar/select-bar.tsx';
import { SelectMenu } from '../panels/select-bar/select-menu.tsx';
import { Hint, Status, StatusNumbers } from '../panels/status-bar/status-bar.tsx';
import { ModelFact, MoveFact, ShapeFact } from '../panels/step-facts.tsx';
import { Tolerance } from '../panels/tolerance.tsx';
import { AppProvider, useApp } from '../store/use-app.ts';
import { Subject } from '../ui/components/use-typed.ts';
import { byId } from '../ui/dom.ts';
import { isEmbedded } from '../ui/embedded.ts';
import { dropRemovedInput } from '../ui/removed-fields.ts';
import { Analysis } from './analysis.tsx';
import type { AppContext } from './context.ts';

/** The components, by the id of their place. */
const PLACES: Record<string, ComponentType> = {
  'fact-open': ModelFact,
  'fact-shape': ShapeFact,
  'fact-move': MoveFact,
  'mesh-tools': MeshTools,
  'lesson-place': Lesson,
  'lesson-card-place': LessonCard,
  'make-panels-place': lockable('constraints', PanelsInStep),
  'panels-card-place': () => (
    <PanelsCard>
      <RunMessage isOnCard />
    </PanelsCard>
  ),
  'more-messages': Warnings,
  'move-tools': VariationsButton,
  corner: () => (
    <>
      <NewPanels />
      <Curvature />
      <SectionCard />
    </>
  ),
  'docked-place': () => (
    <>
      <VariationsPanel />
      <BuildPanel makePanels={makePanels} />
    </>
  ),
  'flat-map-panel-place': FlatMapPanel,
  'flat-map-place': FlatMapRegion,
  'view-menu': ViewMenu,
  model: lockable('mesh', Model, 'the mesh stays as it is'),
  'import-report': ImportReport,
  constraints: lockable('constraints', Constraints, 'the constraints stay as they are'),
  energies: lockable('weights', Energies, 'the weights stay as they are'),
  'solver-tools': HalfStepSwitch,
  handles: lockable('handles', Handles, 'the handles stay as they are'),
  'tolerance-place': Tolerance,
  colours: Colours,
  compare: Compare,
  display: Shown,
  analysis: Analysis,
  status: Status,
  hint: Hint,
  numbers: StatusNumbers,
  hints: FirstHints,
  'example-place': ExampleNote,
  'legend-place': Legend,
  'stage-place': Stage,
  recent: RecentMenu,
  ...(isEmbedded && { 'embed-place': EmbeddedView }),
  'select-bar-place': SelectBar,
  'select-menu-place': SelectMenu,
};

/** What is typed outside of dialogs is meant for the open model. */
const OfModel = ({ children }: { children: ComponentChildren }) => (
  <Subject.Provider value={useApp().store.state.model}>{children}</Subject.Provider>
);

export function renderPage(app: AppContext) {
  dropRemovedInput();
  for (const [id, Component] of Object.entries(PLACES)) {
    const place = byId(id);
    // What is there before this script is loaded.
    place.replaceChildren();
    render(
      <AppProvider value={app}>
        <OfModel>
          <Component />
        </OfModel>
      </AppProvider>,
      place,
    );
  }
}
