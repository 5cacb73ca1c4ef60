/** More settings of a scene: closeness, smoothness, solver. Built from their declarations. */

import './settings.css';
import { Fragment, type ComponentChildren } from 'preact';
import { frameOf } from '../../store/frame.ts';
import { FIT, POSE, readSecondFile } from '../../store/second-files.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { count } from '../../ui/words.ts';
import { useRefusal } from '../../ui/kinds/parameter-refusal.ts';
import { Parameters } from '../../ui/kinds/parameters.tsx';
import type { Setting as SettingInfo } from '../../pkg/engine/shape_up.js';

export function Settings() {
  const { settings } = useApp().store.state;
  const groups = [...new Set(settings.map(({ group }) => group))];
  return (
    <>
      {groups.map((group, i) => (
        <Fragment key={group}>
          <h3>{group}</h3>
          {settings
            .filter((setting) => setting.group === group)
            .map((setting) => (
              <Setting key={setting.id} setting={setting} />
            ))}
          {i === 0 && (
            <>
              <FromFile
                of={FIT}
                label="Fit to another surface"
                words="A second file in the same coordinates: the vertices are pulled onto its surface."
              />
              <Pose />
              <OwnCloseness />
            </>
          )}
        </Fragment>
      ))}
    </>
  );
}

function Setting({ setting }: { setting: SettingInfo }) {
  const { store, actions } = useApp();
  const { document } = store.state;
  const params = [setting];
  const { refusal, refuse, forget } = useRefusal(params);
  const unused = document?.unusedCloseness;
  return (
    <div class="setting">
      <Parameters
        params={params}
        values={document?.settings ?? {}}
        frame={frameOf(store.state)}
        refusal={refusal}
        onValue={(id, value) => {
          forget();
          return actions.edit({ set: { id, value } }, refuse);
        }}
      />
      <p class="quiet">
        {setting.summary} {unused?.settings.includes(setting.id) && unused.why}
      </p>
    </div>
  );
}

/** An edit that reads a second file. */
function FromFile({
  of,
  label,
  words,
  children,
}: {
  of: typeof FIT;
  label: string;
  words: string;
  /** beside the button */
  children?: ComponentChildren;
}) {
  const app = useApp();
  return (
    <div class="setting">
      <label class="button">
        {label} …
        <input
          type="file"
          accept=".obj,.off,.mesh"
          aria-label={label}
          onChange={({ currentTarget }) => {
            const [file] = currentTarget.files ?? [];
            if (file) void app.actions.reportErrors(readSecondFile(of, file, app));
            // Allows the same file to be read again after it changed on disk.
            currentTarget.value = '';
          }}
        />
      </label>
      {children}
      <p class="quiet">{words}</p>
    </div>
  );
}

/** Rest shapes from another pose of the mesh. */
function Pose() {
  const { store, actions } = useApp();
  return (
    <FromFile
      of={POSE}
      label="Take the pose of another file"
      words="A second file with the same faces: rigid and similar constraints keep the shapes in that file."
    >
      {store.state.document?.pose && (
        <Button onClick={() => actions.edit('leavePose')}>Leave the other pose</Button>
      )}
    </FromFile>
  );
}

/** Closeness buttons for the selected vertices, with factors of the weight of closeness. */
const HOLDS = [
  { label: 'More', weight: 10, title: 'Ten times the closeness of the others' },
  { label: 'Less', weight: 0.1, title: 'A tenth of the closeness of the others' },
  { label: 'None', weight: 0, title: 'Nothing keeps them near the original' },
  { label: 'Default', weight: 1, title: 'The same closeness as the others' },
];

/** The closeness of the selected vertices relative to the others. */
function OwnCloseness() {
  const { store, actions } = useApp();
  const { selection, document } = store.state;
  const none = sizeOfSelection(selection) === 0;
  const held = document?.reweightedVertices ?? 0;
  const unused = document?.unusedCloseness?.why;
  // A factor of 0 releases vertices from an exact boundary, and 1 puts them back.
  const releases = document?.settings.boundary === 'exact';
  const notes = [
    unused ||
      (none &&
        'Select vertices to keep them closer to the original, or less close, than the others.'),
    held > 0 && `${count(held, 'vertex has its', 'vertices have their')} own closeness.`,
  ];

  async function hold({ label, weight }: (typeof HOLDS)[number]) {
    await actions.settled();
    const vertices = actions.selectedVertices();
    if ((await actions.edit({ holdClose: { vertices, weight } })) === undefined) return;
    const whose = count(vertices.length, 'vertex', 'vertices');
    actions.setStatus(`Closeness of ${whose}: ${label.toLowerCase()}`);
  }

  return (
    <div class="setting" role="group" aria-label="Closeness of the selection">
      <p>Closeness of the selection</p>
      <div class="row-buttons">
        {HOLDS.map((one) => (
          <Button
            key={one.label}
            title={one.title}
            aria-label={`Closeness of the selection: ${one.label.toLowerCase()}`}
            disabled={none || (!!unused && !(releases && [0, 1].includes(one.weight)))}
            onClick={() => hold(one)}
          >
            {one.label}
          </Button>
        ))}
        {held > 0 && (
          <Button onClick={() => actions.edit({ holdClose: { vertices: null, weight: 1 } })}>
            Same for all
          </Button>
        )}
      </div>
      <p class="quiet">{notes.filter(Boolean).join(' ')}</p>
    </div>
  );
}
