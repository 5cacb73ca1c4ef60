/**
 * The offset: a slider for distances at which no edge flips, the choice of what keeps the distance,
 * with the error of each, and the weight of following the surface.
 */

import { element, setText } from '../../ui/dom.ts';
import type {
  BuildCard,
  BuildChoice,
  BuildSetting,
  BuildSettings,
  CardWords,
} from '../../solver/types.ts';

/** Range of the slider in mean edge lengths, if nothing else limits it. */
const FAR = 2;
/** Fraction of the distance at which an edge would have no length. */
const INSIDE = 0.99;
/** Exponent to base ten of the smallest weight of following. */
const LEAST_FOLLOW = -5;

/**
 * @param declared all settings of Build
 * @param on.tryDistance called during a drag, in the unit of the mesh
 * @param on.restore called for a distance of 0, which parts cannot have
 */
export function thicknessForm(
  declared: BuildSetting[],
  {
    tryDistance,
    restore,
    change,
  }: {
    tryDistance: (distance: number) => void;
    restore: () => void;
    change: (change: Partial<BuildSettings>) => void;
  },
) {
  const [distanceWords, kindWords, followWords] = ['distance', 'kind', 'follow'].map((id) =>
    declared.find((setting) => setting.id === id),
  );
  /** Millimetres of the building per unit of the mesh. */
  let scale = 1000;
  const slider = element('input', {
    ...{ type: 'range', id: 'parts-distance', step: 'any' },
    oninput: () => {
      if (slider.valueAsNumber !== 0) tryDistance(slider.valueAsNumber);
    },
    onchange: () => {
      if (slider.valueAsNumber !== 0) change({ distance: slider.valueAsNumber });
      else restore();
    },
  });
  const figure = element('output', { for: 'parts-distance' });
  const ends = element('p.quiet');
  const kinds = kindWords?.form.type === 'choice' ? kindWords.form.options : [];
  const buttons = kinds.map(({ word, label, summary: title }) => {
    const kind = word as BuildChoice['kind'];
    const error = element('span.quiet');
    const one = element(
      'button.bordered',
      { title, onclick: () => change({ kind: one.ariaPressed === 'true' ? null : kind }) },
      element('span', label),
      error,
    );
    return { kind, one, error };
  });
  const follow = element('input', {
    ...{ type: 'range', id: 'parts-follow', min: String(LEAST_FOLLOW), max: '0', step: '0.5' },
    title: followWords?.summary ?? '',
    onchange: () => change({ follow: Number((10 ** follow.valueAsNumber).toPrecision(2)) }),
  });
  const followRow = element(
    'div.field-row',
    element('label', { for: 'parts-follow' }, followWords?.label ?? ''),
    follow,
  );
  const keepsId = 'parts-keeps';
  const place = element(
    'div.thickness',
    element(
      'div.heading',
      element('label', { for: 'parts-distance' }, distanceWords?.label ?? ''),
      figure,
    ),
    slider,
    ends,
    element('span', { id: keepsId }, kindWords?.label ?? ''),
    element(
      'div.kinds',
      { role: 'group', 'aria-labelledby': keepsId },
      ...buttons.map(({ one }) => one),
    ),
    followRow,
  );

  return {
    place,
    /** @param metres per unit of the mesh */
    update(
      { report, words }: { report: BuildCard; words: CardWords },
      settings: BuildSettings,
      metres: number,
    ) {
      const { offset, mean_edge_mm: edge } = report;
      place.hidden = !offset;
      if (!offset) return;
      scale = 1000 * metres;
      const far = FAR * edge;
      const [inwards, outwards] = offset.safe_distance_mm;
      const low = Math.max(-far, INSIDE * (inwards ?? -Infinity));
      const high = Math.min(far, INSIDE * (outwards ?? Infinity));
      slider.min = String(low / scale);
      slider.max = String(high / scale);
      setText(figure, words.distance);
      slider.setAttribute('aria-valuetext', figure.textContent ?? '');
      if (!slider.matches(':active')) slider.value = String(offset.distance_mm / scale);
      setText(ends, words.safe);
      for (const { kind, one } of buttons) {
        one.ariaPressed = String(kind === settings.kind);
        one.classList.toggle('proposed', settings.kind === null && kind === offset.kind);
      }
      followRow.hidden = offset.exact;
      if (document.activeElement !== follow) follow.value = String(Math.log10(settings.follow));
    },
    /** Shows the error that each kind would have. */
    offer(choices: BuildChoice[]) {
      for (const { kind, error } of buttons) {
        const own = choices.find((choice) => choice.kind === kind);
        setText(error, own?.words ?? '');
      }
    },
  };
}
