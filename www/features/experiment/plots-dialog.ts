/** The dialog of an experiment: runs its methods one after another and plots their progress. */

import { button } from '../../ui/controls/fields.ts';
import { element, setText, throttled } from '../../ui/dom.ts';
import { saveFile } from '../../ui/save-file.ts';
import { groupDigits, length, number } from '../../ui/format.ts';
import { linesSvg } from '../../ui/plot/lines-svg.ts';
import { messageOf, type NamedBytes, type FromWorker } from '../../solver/messages.ts';
import { Chart } from './chart.ts';
import './plots-dialog.css';
import type { Experiment } from '../../solver/examples.ts';
import type { AppContext } from '../../app/context.ts';

/** The files of an example, or null for the open document; and the base name of saved files. */
type Subject = { of: { example: string; files: NamedBytes[] } | null; name: string };

/** The samples of a method: in each iteration the seconds, then the quantities. */
type Series = { columns: number[][]; endedBy: string | null };

const DRAW_EVERY_MS = 150;

export class ExperimentDialog {
  #experiment;
  #subject;
  #store;
  #solver;
  #actions;
  #dialog;
  #series: Series[] = [];
  #running = false;
  /** Remove the listeners on the solver. */
  #stops: (() => void)[] = [];
  /** Called when the worker has died and its measurements are lost. */
  #lost = () => this.#running && this.#fail('the solver was restarted');
  #draw;

  #status = element('p.experiment-status.quiet', { role: 'status' });
  #progress = element('progress', { 'aria-label': 'Progress' });
  #run = element('button.primary', { onclick: () => this.#runOrCancel() }, 'Run all');
  #csv = button('Save CSV', () => this.#saveCsv(), { disabled: true });
  #rows = element('tbody');
  #charts: Chart[] = [];
  #limits;
  #most;

  constructor(experiment: Experiment, subject: Subject, { store, solver, actions }: AppContext) {
    this.#experiment = experiment;
    this.#subject = subject;
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    this.#limits = { ...experiment.limits };
    this.#most = element('input', {
      ...{ type: 'number', id: 'experiment-iterations', min: 1, max: 100_000, step: 1 },
      ...{ required: true, value: experiment.limits.iterations },
    });
    this.#draw = throttled(DRAW_EVERY_MS, () => this.#drawNow());
    this.#dialog = element(
      'dialog.experiment',
      { 'aria-labelledby': 'experiment-title', onclose: () => this.#closed() },
      element(
        'header',
        element('h2', { id: 'experiment-title' }, experiment.label),
        element(
          'button.square',
          { 'aria-label': 'Close experiment', onclick: () => this.#dialog.close() },
          '×',
        ),
      ),
      element('p.summary', experiment.summary),
      element(
        'div.experiment-tools',
        this.#run,
        this.#csv,
        element(
          'label.most',
          'At most ',
          this.#most,
          ` iterations and ${experiment.limits.seconds} s each`,
        ),
        this.#progress,
        this.#status,
      ),
      this.#figures(),
      this.#table(),
    );
  }

  open() {
    document.body.append(this.#dialog);
    this.#dialog.showModal();
    this.#stops = [
      this.#solver.on('experiment', (news) => this.#take(news)),
      this.#solver.on('restarted', () => this.#lost()),
    ];
    const figures = this.#dialog.querySelectorAll('figure');
    this.#charts = this.#experiment.plots.map(
      (plot, k) =>
        new Chart(figures[k], {
          label: this.#title(plot),
          names: this.#experiment.methods.map((method) => method.label),
          x: plot.over === 'seconds' ? 0 : null,
          y: 1 + plot.quantity,
          aboveLowest: plot.above_lowest,
        }),
    );
    this.#progress.hidden = true;
    this.#fillTable();
    const on = this.#subject.of ? 'on the original example' : 'from the original shape';
    setText(this.#status, `Runs in this browser, ${on}. Nothing is stored.`);
  }

  #closed() {
    if (this.#running) this.#actions.cancelExperiment();
    this.#stops.forEach((stop) => stop());
    this.#charts.forEach((chart) => chart.destroy());
    this.#dialog.remove();
  }

  async #runOrCancel() {
    if (this.#running) return this.#actions.cancelExperiment();
    if (!this.#most.reportValidity()) return;
    this.#limits.iterations = this.#most.valueAsNumber;
    this.#series = [];
    this.#setRunning(true);
    try {
      await this.#actions.runExperiment(this.#subject.of, this.#limits.iterations);
    } catch (error) {
      this.#fail(messageOf(error));
    }
  }

  #take({ news, ended, message }: Extract<FromWorker, { type: 'experiment' }>) {
    const width = 2 + this.#experiment.quantities.length;
    for (const { method, endedBy, samples } of news) {
      const series = (this.#series[method] ??= {
        columns: Array.from({ length: width - 1 }, () => []),
        endedBy: null,
      });
      series.endedBy = endedBy;
      for (let at = 0; at < samples.length; at += width) {
        series.columns.forEach((column, k) => column.push(samples[at + 1 + k]));
      }
    }
    if (ended === 'failed') this.#fail(message);
    else if (ended) {
      this.#setRunning(false);
      // The end is announced together with the final values.
      this.#drawNow();
      setText(this.#status, ended === 'done' ? 'All methods have ended.' : 'Cancelled.');
    }
    this.#draw();
  }

  #fail(message: string) {
    this.#setRunning(false);
    setText(this.#status, `The experiment failed: ${message}`);
  }

  #setRunning(running: boolean) {
    this.#running = running;
    setText(this.#run, running ? 'Cancel' : 'Run all');
    this.#run.classList.toggle('primary', !running);
    this.#run.classList.toggle('bordered', running);
    this.#progress.hidden = !running;
    this.#csv.disabled = running || this.#series.length === 0;
    this.#draw();
  }

  async #saveCsv() {
    try {
      const text = await this.#actions.experimentCsv();
      saveFile(`${this.#subject.name}.csv`, text, 'text/csv');
    } catch (error) {
      setText(this.#status, `The table could not be saved: ${messageOf(error)}`);
    }
  }

  /** @param k index of the plot */
  #saveSvg(k: number) {
    const plot = this.#experiment.plots[k];
    const title = `${this.#experiment.label}: ${this.#subject.name}`;
    const words = { title, x: plot.over, y: this.#title(plot) };
    const text = linesSvg(this.#charts[k].lines(), words);
    saveFile(`${this.#subject.name} ${plot.over}.svg`, text, 'image/svg+xml');
  }

  #drawNow() {
    const { methods } = this.#experiment;
    if (this.#running) {
      const done = this.#series.filter((series) => series.endedBy).length;
      const now = this.#series.at(-1);
      const part = now && !now.endedBy ? partOf(now, this.#limits) : 0;
      this.#progress.max = methods.length;
      this.#progress.value = Math.min(done + part, methods.length);
      const method = methods[Math.min(done, methods.length - 1)];
      setText(this.#status, `${method.label}, ${done + 1} of ${methods.length}`);
    }
    for (const chart of this.#charts) chart.show(this.#series.map((series) => series.columns));
    this.#fillTable();
  }

  #figures() {
    const titles = this.#experiment.plots.map((plot, k) => {
      const title = this.#title(plot);
      const save = element(
        'button.tiny',
        { 'aria-label': `Save SVG: ${title}`, onclick: () => this.#saveSvg(k) },
        'SVG',
      );
      return element('figure', element('figcaption', title, save));
    });
    const key = this.#experiment.methods.map((method, k) =>
      element(
        'li',
        { title: method.summary },
        element('span.swatch', { style: `--chip: var(--line-of-method-${k})` }),
        method.label,
      ),
    );
    return element(
      'div.experiment-plots',
      element('ul.experiment-key', { 'aria-label': 'Methods' }, ...key),
      ...titles,
    );
  }

  #table() {
    const heads = [
      'Method',
      'Iterations',
      'Seconds',
      ...this.#experiment.quantities.map(({ label }) => label),
      'Ended by',
    ];
    return element(
      'div.experiment-table',
      element(
        'table',
        element(
          'thead',
          element('tr', ...heads.map((head) => element('th', { scope: 'col' }, head))),
        ),
        this.#rows,
      ),
    );
  }

  #fillTable() {
    const { units } = this.#store.get().document ?? { units: '' };
    const rows = this.#experiment.methods.map((method, k) => {
      const series = this.#series[k];
      // A method for which the mesh is too large has no samples.
      const begun = series && series.columns[0].length > 0;
      const last = begun ? series.columns.map((column) => column.at(-1) ?? 0) : null;
      const values = this.#experiment.quantities.map(({ unit }, q) =>
        last ? written(last[1 + q], unit, units) : '',
      );
      const cells = [
        last ? groupDigits(series.columns[0].length - 1) : '',
        last ? number(last[0]) : '',
        ...values,
        series?.endedBy ?? '',
      ];
      return element(
        'tr',
        element('th', { scope: 'row', title: method.summary }, method.label),
        ...cells.map((cell) => element('td', cell)),
      );
    });
    this.#rows.replaceChildren(...rows);
  }

  /** The title of a plot, with its unit. */
  #title(plot: Experiment['plots'][number]) {
    const { quantity, over } = plot;
    const { label, unit } = this.#experiment.quantities[quantity];
    const units = this.#store.get().document?.units;
    const written = { energy: ` in ${units}²`, length: ` in ${units}`, none: '' }[unit];
    const what = plot.above_lowest ? `${label} above the lowest` : label;
    return `${what}${units ? written : ''} over ${over}`;
  }
}

/** Fraction of its limits that a method has used. */
function partOf({ columns }: Series, limits: { iterations: number; seconds: number }) {
  const [seconds] = columns;
  return Math.max(seconds.length / limits.iterations, (seconds.at(-1) ?? 0) / limits.seconds);
}

/** @param units of the mesh */
function written(value: number, unit: 'energy' | 'length' | 'none', units: string) {
  if (unit === 'length') return length(value, units);
  if (unit === 'energy' && units) return `${number(value)} ${units}²`;
  return number(value);
}
