/**
 * Offers the experiment of the example that is open. The dialog that runs it, with its plots, is
 * loaded when it is asked for.
 */

import { byId, element } from '../../ui/dom.js';
import { messageOf } from '../../solver/messages.js';

/**
 * @param {import("../../app/context.js").AppContext} app
 */
export function offerExperiment(app) {
  const place = byId('experiment');
  const { store, alerts } = app;

  async function open() {
    const { example } = store.get();
    if (!example?.experiment) return;
    try {
      const { ExperimentDialog } = await import('./plots-dialog.js');
      new ExperimentDialog(example, example.experiment, app).open();
    } catch (error) {
      alerts.error(`The experiment could not be loaded: ${messageOf(error)}`);
    }
  }

  store.subscribe(['example'], ({ example }) => {
    const experiment = example?.experiment;
    place.hidden = !experiment;
    if (!experiment) return place.replaceChildren();
    place.replaceChildren(
      element('p', element('strong', 'Experiment: '), experiment.label),
      element('button.bordered', { 'aria-haspopup': 'dialog', onclick: open }, 'Compare methods'),
    );
  });
}
