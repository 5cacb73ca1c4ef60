/** The docked panel of parts: settings, the build check, the sheets and their files. */

import './build-panel.css';
import { useEffect, useRef } from 'preact/hooks';
import { Docked } from '../../docked/docked.tsx';
import { askRhino } from '../../documents/rhino/rhino-client.ts';
import { openPrepared } from '../../store/show-dialog.tsx';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { oneAtATime } from '../../ui/once.ts';
import { CheckCard, type MakePanels } from './check-card.tsx';
import { theParts } from './parts.ts';
import { showReport } from './report.tsx';
import { Settings } from './settings.tsx';
import { Sheets } from './sheets.tsx';
import { Thickness } from './thickness.tsx';
import { TypesCurve } from './types-curve.tsx';
import type { AppContext } from '../../app/context.ts';
import type { LiveBuild } from './live-build.ts';

const openReport = oneAtATime((app: AppContext, live: LiveBuild) =>
  openPrepared(app, () => showReport(app, live)),
);

const save = oneAtATime(({ files }: AppContext, live: LiveBuild) =>
  files.save('-parts.zip', 'application/zip', () => live.zip()),
);

/** Saves a 3DM file, loading its large writer. */
const saveForRhino = oneAtATime(({ files }: AppContext, live: LiveBuild) =>
  files.save('-parts.3dm', 'model/vnd.3dm', async () => {
    const [made, { symbol }] = [await live.spatialParts(), live.unit()];
    return askRhino((rhino) => rhino.writeParts(made, symbol));
  }),
);

/** The panel, while it is docked. */
export function BuildPanel(props: { makePanels: MakePanels }) {
  return useApp().store.state.docked === 'parts' ? <Panel {...props} /> : null;
}

function Panel({ makePanels }: { makePanels: MakePanels }) {
  const app = useApp();
  const { store, actions } = app;
  const parts = theParts(app);
  const { live } = parts;
  useEffect(() => parts.begin(), [parts]);
  const offers = parts.offers.value;
  const built = parts.built.value;
  const refused = parts.refused.value;
  /** The scene has the settings and the unit; while a mesh is replaced there is none. */
  const hadDocument = useRef(false);
  hadDocument.current ||= store.state.document !== null;
  const isDisabled = !offers || refused !== '';

  const head = (
    <>
      <p aria-live="polite">{built?.words.sheets}</p>
      <Button disabled={isDisabled} onClick={() => actions.reportErrors(openReport(app, live))}>
        Report
      </Button>
      <Button
        title="Panels, beams, nodes and sheets as layers of a .3dm file"
        disabled={isDisabled}
        onClick={() => actions.reportErrors(saveForRhino(app, live))}
      >
        Rhino
      </Button>
      <Button
        class="primary"
        disabled={isDisabled}
        onClick={() => actions.reportErrors(save(app, live))}
      >
        Save drawings and tables
      </Button>
    </>
  );
  return (
    <Docked of="parts" title="Build: parts and sheets" head={head}>
      {offers && hadDocument.current && (
        <div class="docked-columns parts-columns">
          <Settings parts={parts} offers={offers} />
          <div class="parts-check">
            {built?.words.advice.map(({ words, choices }) => (
              <div key={words} class="notice advice">
                <p>{words}</p>
                {choices.map(({ label, setting, value }) => (
                  <Button key={label} onClick={() => parts.change({ [setting]: value })}>
                    {label}
                  </Button>
                ))}
              </div>
            ))}
            {built?.words.joint && <p class="quiet">{built.words.joint}</p>}
            <Thickness parts={parts} declared={offers.settings} />
            <CheckCard parts={parts} makePanels={makePanels} />
            <TypesCurve parts={parts} />
            {refused && (
              <div class="notice advice">
                <p>{refused}</p>
                <Button onClick={() => actions.reportErrors(live.again())}>Build again</Button>
              </div>
            )}
            {built?.words.warnings.map((words) => (
              <p key={words} class="notice">
                {words}
              </p>
            ))}
          </div>
          <Sheets parts={parts} />
        </div>
      )}
    </Docked>
  );
}
