/**
 * The components of the page, as one tree. It stands in places of `index.html`, whose header, headings
 * and buttons are the first that is painted, before any script: as components they would be in the
 * script a second time, to no other effect.
 */

import { createPortal, render, type ComponentChildren } from 'preact';
import { ExamplesMenu } from '../documents/examples-menu.tsx';
import { RecentMenu } from '../documents/recent-menu.tsx';
import { BuildPanel } from '../features/build/build-panel.tsx';
import { Curvature } from '../features/curvature/curvature-card.tsx';
import { EmbeddedView } from '../features/embed/embedded-view.tsx';
import { FlatMapPanel } from '../features/flat-map/flat-map-panel.tsx';
import { FlatMapRegion } from '../features/flat-map/flat-map-region.tsx';
import { Lesson, LessonCard, Lockable } from '../features/lesson/panel.tsx';
import { MeshTools, PanelsInStep } from '../features/make-panels/buttons.tsx';
import { PanelsCard } from '../features/make-panels/card.tsx';
import { makePanels } from '../features/make-panels/press.ts';
import { NewPanels } from '../features/make-panels/new-panels.tsx';
import { ContextMenu } from '../features/selecting/context-menu.tsx';
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

/** What is typed outside of dialogs is meant for the open model. */
const OfModel = ({ children }: { children: ComponentChildren }) => (
  <Subject.Provider value={useApp().store.state.model}>{children}</Subject.Provider>
);

/** The parts of the page, by the id of their place. */
const PARTS: Record<string, ComponentChildren> = {
  'fact-open': <ModelFact />,
  'lesson-place': <Lesson />,
  'model-place': (
    <>
      <div id="model">
        <Lockable lock="mesh" words="the mesh stays as it is">
          <Model />
        </Lockable>
      </div>
      <div id="import-report">
        <ImportReport />
      </div>
      <ExampleNote />
    </>
  ),
  'mesh-tools': <MeshTools />,
  'fact-shape': <ShapeFact />,
  'shape-place': (
    <>
      <Lockable lock="constraints">
        <PanelsInStep />
      </Lockable>
      <Tolerance />
      <div>
        <Lockable lock="constraints" words="the constraints stay as they are">
          <Constraints />
        </Lockable>
      </div>
    </>
  ),
  energies: (
    <Lockable lock="weights" words="the weights stay as they are">
      <Energies />
    </Lockable>
  ),
  'solver-tools': <HalfStepSwitch />,
  'fact-move': <MoveFact />,
  handles: (
    <Lockable lock="handles" words="the handles stay as they are">
      <Handles />
    </Lockable>
  ),
  'move-tools': <VariationsButton />,
  colours: [<FlatMapPanel />, <Colours />],
  compare: <Compare />,
  display: <Shown />,
  analysis: <Analysis />,
  'over-view': [
    <NewPanels />,
    <Curvature />,
    <SectionCard />,
    <SelectBar />,
    <FlatMapRegion />,
    <LessonCard />,
  ],
  'more-messages': <Warnings />,
  hints: <FirstHints />,
  'below-view': (
    <>
      <Legend />
      <PanelsCard>
        <RunMessage isOnCard />
      </PanelsCard>
    </>
  ),
  'docked-place': [<VariationsPanel />, <BuildPanel makePanels={makePanels} />],
  status: <Status />,
  hint: <Hint />,
  numbers: <StatusNumbers />,
  'stage-place': [isEmbedded && <EmbeddedView />, <Stage />],
  'menus-place': [<ExamplesMenu />, <RecentMenu />, <ViewMenu />, <SelectMenu />, <ContextMenu />],
};

export function renderPage(app: AppContext) {
  dropRemovedInput();
  const portals = Object.entries(PARTS).map(([id, part]) => {
    const place = byId(id);
    // What is there before this script is loaded.
    place.replaceChildren();
    return createPortal(part, place);
  });
  render(
    <AppProvider value={app}>
      <OfModel>{portals}</OfModel>
    </AppProvider>,
    document.createElement('div'),
  );
}
