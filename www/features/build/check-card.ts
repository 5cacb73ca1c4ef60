/** The build check: five numbers with their limits; clicking one shows its worst element. */

import { button } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import type {
  BuildCard,
  BuildReport,
  CardWords,
  CheckRow,
  CheckWords,
} from '../../solver/types.ts';
import type { State } from '../../store/state.ts';

type Suggestion = BuildReport['tighten']['suggestions'][number];

/** @param show shows an element of the mesh */
export function checkCard(
  show: (worst: CheckRow['worst']) => void,
  tighten: (suggestion: Suggestion) => void,
) {
  const words = element('p.quiet');
  const list = element('ul.check-rows');
  const problems = element('div');
  /** The suggestion on offer. */
  let suggestion: Suggestion | undefined;
  const reason = element('p.quiet', { id: 'tighten-reason' });
  const press = button('Tighten', () => suggestion && tighten(suggestion), {
    'aria-describedby': 'tighten-reason',
  });
  const card = element(
    'div.check-card',
    list,
    element('div.tighten', press, reason),
    words,
    problems,
  );
  return {
    card,
    update(
      { report, words: said }: { report: BuildCard; words: CardWords },
      { model }: Pick<State, 'model'>,
    ) {
      const { suggestions, otherwise } = report.tighten;
      const at = suggestions.findIndex(({ constraint }) =>
        model?.panels.some(({ kind, reason }) => kind === constraint && !reason),
      );
      suggestion = suggestions[at];
      press.disabled = !suggestion;
      setText(reason, said.suggestions[at] ?? otherwise);
      list.replaceChildren(...report.check.map((row, k) => checkRow(row, said.check[k], show)));
      words.textContent = said.offset;
      problems.replaceChildren(...report.problems.map((problem) => element('p.notice', problem)));
    },
  };
}

function checkRow(
  { label, met, worst }: CheckRow,
  said: CheckWords,
  show: (worst: CheckRow['worst']) => void,
) {
  const state = met === null ? 'none' : met ? 'met' : 'missed';
  const parts = [
    element('span.mark', { 'aria-hidden': 'true' }, { none: '–', met: '✓', missed: '✗' }[state]),
    element('span.label', label),
    element('span.figure', said.value),
    element('span.quiet.bound', said.limit),
    met === false && element('span.quiet.missed', said.state),
  ];
  const title = 'Show where it is worst';
  const inside =
    worst === 'none'
      ? element('div', ...parts)
      : element('button', { title, onclick: () => show(worst) }, ...parts);
  return element('li', { 'data-state': state }, inside);
}
