/** The dialog that saves a student's results for hand-in. */

import './lesson.css';
import { openDialog } from '../../ui/controls/dialog.ts';
import { element } from '../../ui/dom.ts';
import type { AppContext } from '../../app/context.ts';

export function handIn({ store, files, actions }: AppContext) {
  const name = element('input', {
    type: 'text',
    id: 'student',
    autocomplete: 'name',
    maxlength: '120',
    required: true,
  });
  const goals = store.get().numbers?.goals ?? [];
  const met = goals.filter((goal) => goal.met).length;
  const form = element(
    'form.dialog-body',
    { method: 'dialog', onsubmit: save },
    element('label.line', 'Your name', name),
    element(
      'p',
      `${met} of ${goals.length} goals are met now. The file contains the shape, the goals with their values, each step that you made, and the time.`,
    ),
    element(
      'p.quiet',
      'The file is saved only on this computer: send it in as you send other work. The recipient can measure the shape again.',
    ),
    element('div.dialog-buttons', element('button.primary', { type: 'submit' }, 'Save the file')),
  );
  openDialog({ id: 'hand-in', title: 'Results for hand-in' }, form);
  name.focus();

  async function save() {
    const student = name.value.trim();
    const time = new Date().toISOString();
    const text = await actions.reportErrors(actions.ask.results(student, time));
    if (text) files.save('.results.json', text, 'application/json');
  }
}
