/** The Refine dialog: scheme, number of levels, and resulting number of faces. */

import './refine.css';
import { useMemo, useState } from 'preact/hooks';
import { messageOf } from '../../solver/errors.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { useAnswerTo } from '../../store/use-answer.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { AmountField, Choice } from '../../ui/components/fields.tsx';
import { count, limit, rounded } from '../../ui/words.ts';
import type { Refinement } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';

type Scheme = 'catmull-clark' | 'linear' | 'loop';
const SCHEMES: [Scheme, string][] = [
  ['catmull-clark', 'Catmull-Clark, smooth'],
  ['linear', 'Linear, edges stay'],
];
const FOR_TRIANGLES: [Scheme, string] = ['loop', 'Loop, smooth'];
type Reference = 'solved' | 'original';
/** The reference of each level of Refine and solve. */
const CLOSE_TO: [Reference, string][] = [
  ['solved', 'The solved level: faster, smoother'],
  ['original', 'The original: nearer to it'],
];
const FROM: Record<Reference, string> = {
  solved: 'Refine and solve measures “Moved” from the last level that was solved.',
  original: '“Moved” is measured from the refined original.',
};
const OFTEN = ['Once', 'Twice', 'Three times', 'Four times', 'Five times'];
/** Default angle in degrees above which creases and corners stay sharp. */
const SHARP_ABOVE = 75;

/** Opens the dialog. */
export function openRefine(app: AppContext) {
  showDialog(app, { id: 'refine', title: 'Refine', light: true }, RefineDialog);
}

function RefineDialog({ close }: InDialog) {
  const { store, solver, actions, mesh } = useApp();
  const { geometry } = solver;
  const { document, model } = store.state;
  const hasRows = document?.constraints.some((row) => row.enabled) ?? false;
  const schemes = useMemo(() => {
    const { faceOffsets, faceIndices } = geometry?.connectivity ?? {};
    const faces = (faceOffsets?.length ?? 1) - 1;
    return faceIndices?.length === 3 * faces ? [FOR_TRIANGLES, ...SCHEMES] : SCHEMES;
  }, []);
  const [scheme, setScheme] = useState(schemes[0][0]);
  const [sharpAbove, setSharpAbove] = useState(SHARP_ABOVE);
  /** The level that was chosen, from 1. */
  const [wanted, setLevel] = useState(1);
  const [closeTo, setCloseTo] = useState<Reference>('solved');
  const { made, refused, isReady } = useRefinements(scheme, sharpAbove);
  const isAdopted = hasRows && closeTo === 'solved';
  // Another scheme may have fewer.
  const level = Math.min(wanted, Math.max(made.length, 1));
  const chosen = isReady ? made[level - 1] : undefined;
  const units = document?.units ?? '';

  /** The option for a number of levels, with its result. */
  function option({ faces, edge }: Refinement, i: number) {
    const far = limit(rounded(edge, 2), units);
    const times = OFTEN[i] ?? `${i + 1} times`;
    const result = isReady ? `: ${count(faces, 'face')} of about ${far}` : '';
    return [String(i + 1), times + result] as const;
  }

  function start(solves: boolean) {
    close();
    const how = { scheme, levels: level, keep: sharpAbove, adopt: solves && isAdopted };
    void actions.reportErrors(mesh.refine(how, solves));
  }

  return (
    <div class="dialog-body">
      <label>
        <span>New faces</span>
        <Choice value={scheme} options={schemes} onChoose={(value) => setScheme(value as Scheme)} />
      </label>
      <label>
        <span>How many times</span>
        <Choice
          value={String(level)}
          options={made.map(option)}
          onChoose={(value) => setLevel(Number(value))}
        />
      </label>
      <label>
        <span>Keep creases above, in degrees</span>
        <AmountField
          max={180}
          step={1}
          value={sharpAbove}
          onAmount={setSharpAbove}
          onEmpty={() => setSharpAbove(SHARP_ABOVE)}
        />
      </label>
      {hasRows && (
        <label>
          <span>Each level stays close to</span>
          <Choice
            value={closeTo}
            options={CLOSE_TO}
            onChoose={(value) => setCloseTo(value as Reference)}
          />
        </label>
      )}
      <p aria-live="polite">
        {isReady && refused}
        {chosen &&
          `${count(model?.faces ?? 0, 'face becomes', 'faces become')} ${count(chosen.faces, 'face')}, with ${count(chosen.vertices, 'vertex', 'vertices')}.`}
      </p>
      <p class="quiet">
        The boundary is refined as a curve of its own; creases and corners that turn by more than
        this angle stay sharp. Sets, constraints and handles are carried over as far as they fit.{' '}
        <span>{isAdopted ? FROM.solved : FROM.original}</span>
      </p>
      <div class="dialog-buttons">
        {hasRows && (
          <Button
            class="primary"
            title="Solves, refines and solves again, level by level; Pause stops it"
            disabled={!chosen}
            onClick={() => start(true)}
          >
            Refine and solve
          </Button>
        )}
        <Button
          class={hasRows ? 'bordered' : 'primary'}
          disabled={!chosen}
          onClick={() => start(false)}
        >
          Refine now
        </Button>
      </div>
    </div>
  );
}

/**
 * The result of each number of levels, or why there is none. Until `isReady`, they are those of what was
 * asked before.
 */
function useRefinements(scheme: Scheme, sharpAbove: number) {
  const { ask } = useApp().actions;
  const { answer, isCurrent } = useAnswerTo([scheme, sharpAbove], () =>
    ask.refinements(scheme, sharpAbove).then(
      (made) => ({ made, refused: '' }),
      (error) => ({ made: [], refused: messageOf(error) }),
    ),
  );
  return { made: [], refused: '', ...answer, isReady: isCurrent };
}
