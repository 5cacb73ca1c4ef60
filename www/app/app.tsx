/** The components of the page, each in its place of `index.html`, which is there before them. */

import { render, type ComponentType } from 'preact';
import { Curvature } from '../features/curvature/curvature-card.tsx';
import { MeshTools, PanelsInStep } from '../features/make-panels/buttons.tsx';
import { PanelsCard } from '../features/make-panels/card.tsx';
import { NewPanels } from '../features/make-panels/new-panels.tsx';
import { VariationsButton } from '../features/variations/variations-panel.tsx';
import { ViewMenu } from '../features/view-tools/view-menu.tsx';
import { RunMessageOnCard } from '../features/warnings/run-message.tsx';
import { Warnings } from '../features/warnings/warnings.tsx';
import { Colours } from '../panels/colours/colours.tsx';
import { Shown } from '../panels/colours/shown.tsx';
import { Constraints } from '../panels/constraints/constraints.tsx';
import { MoveFact, ShapeFact } from '../panels/step-facts.tsx';
import { AppProvider } from '../store/use-app.ts';
import { byId } from '../ui/dom.ts';
import type { AppContext } from './context.ts';

/** The components, by the id of their place. */
const PLACES: Record<string, ComponentType> = {
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
  'view-menu': ViewMenu,
  constraints: Constraints,
  colours: Colours,
  display: Shown,
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
