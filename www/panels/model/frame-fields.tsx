/**
 * The unit and the vertical axis of the model: fields that show whether they were guessed and
 * remember the choice by the contents of the file. The coordinates never change.
 */

import { useEffect } from 'preact/hooks';
import { rememberFrame, type Frame } from '../../documents/known-frames.ts';
import { frameOf } from '../../store/frame.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import { unitsOfLength } from '../../ui/words.ts';
import type { Loaded } from '../../solver/types.ts';

/** Units, and the empty string for a mesh without a unit. */
const SYMBOLS = [...unitsOfLength(), ''];
const NO_UNIT = 'no unit';

export function FrameFields({ model }: { model: Loaded }) {
  const { store, actions, files } = useApp();
  const { document, frameChosen } = store.state;
  const { units, up, guessed } = frameOf(store.state);
  const symbols = SYMBOLS.includes(units) ? SYMBOLS : [units, ...SYMBOLS];
  const guess = guessInWords(guessed);

  // Undo and Redo change what was chosen, or take it back.
  useEffect(() => {
    if (!document || !frameChosen?.digest) return;
    rememberFrame(frameChosen.digest, { units, up }, guessed);
  }, [frameChosen, units, up]);

  /** Changes unit or axis, or confirms a guess. */
  function change(part: Partial<Frame>) {
    const { digest } = files;
    const isConfirmed = (one: keyof Frame) =>
      frameChosen?.[one] || part[one] === model.guessed[one];
    actions.look({ frameChosen: { digest, units: isConfirmed('units'), up: isConfirmed('up') } });
    if (part.units !== undefined && part.units !== units)
      void actions.edit({ setUnits: { units: part.units } });
    if (part.up && part.up !== up) void actions.edit({ setUp: { up: part.up } });
  }

  return (
    <div
      class="frame-fields"
      title="Unit and vertical axis of the coordinates. The coordinates do not change."
    >
      {guess && (
        <p class="guess">
          <span>{guess}</span>
          {/* Confirms the guess: nothing changes, but the file is remembered. */}
          <Button class="small bordered" onClick={() => change({ units, up })}>
            Yes
          </Button>
        </p>
      )}
      <label for="units">Unit</label>
      <Choice
        id="units"
        value={units}
        options={symbols.map((unit) => [unit, unit || NO_UNIT] as const)}
        onChoose={(chosen) => change({ units: chosen })}
      />
      <label for="up">Up axis</label>
      <Choice
        id="up"
        value={up}
        options={[
          ['z', 'z'],
          ['y', 'y'],
        ]}
        onChoose={(chosen) => change({ up: chosen === 'y' ? 'y' : 'z' })}
      />
    </div>
  );
}

/**
 * Asks about the unit or axis that was guessed because the file has none; empty if nothing was.
 */
function guessInWords(guessed: Record<keyof Frame, boolean>) {
  if (guessed.units && guessed.up) return 'Unit and up axis are not in the file. Are these right?';
  if (guessed.units) return 'The unit is not in the file. Is this right?';
  return guessed.up ? 'The up axis is not in the file. Is this right?' : '';
}
