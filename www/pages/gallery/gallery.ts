/** The gallery: the first models, the figures and the lessons, filtered by words, figure and constraint. */

import { byId, element } from '../../ui/dom.ts';
import { listOfExamples, type Example } from '../../solver/examples.ts';
import { count } from '../../ui/words.ts';
import { messageOf } from '../../solver/errors.ts';
import { card, type Result } from './card.ts';

document.documentElement.dataset.started = '';

type Entry = { example: Example; words: string; card: HTMLElement; section: HTMLElement };

const RESULTS = new URL(/* @vite-ignore */ 'pictures/results.json', document.baseURI);

const query: HTMLInputElement = byId('query');
const figure: HTMLSelectElement = byId('figure');
const kind: HTMLSelectElement = byId('kind');

/** Headings of the figures. */
const TITLES: Record<number, string> = {
  1: 'one solver, many geometries',
  4: 'local and global step',
  5: 'planar and circular panels',
  6: 'shape exploration',
  7: 'mesh quality',
  8: 'deformation',
  9: 'conformal parametrisation',
  10: 'convergence',
  11: 'collapsing edges',
};

/** The heading of the lessons. */
const LESSONS = 'Lessons';

try {
  const [examples, results] = await Promise.all([listOfExamples(), measured()]);
  const entries = build(examples, results);
  offer(figure, 'All', figuresOf(examples));
  offer(kind, 'All', kindsOf(examples));
  const filter = () => show(entries);
  for (const control of [query, figure, kind]) control.addEventListener('input', filter);
  byId('filters').addEventListener('submit', (event) => event.preventDefault());
  filter();
  // The fragment of the address refers to a card, which did not exist when the page loaded.
  document.getElementById(location.hash.slice(1))?.scrollIntoView();
} catch (error) {
  byId('cards').replaceChildren();
  byId('trouble').textContent = messageOf(error);
}

async function measured(): Promise<Result[]> {
  const response = await fetch(RESULTS);
  if (!response.ok)
    throw new Error(
      `The measurements of the gallery could not be loaded (HTTP ${response.status}).`,
    );
  return response.json();
}

/** Builds a section for each figure, in the order of the examples. */
function build(examples: Example[], results: Result[]): Entry[] {
  const entries: Entry[] = [];
  const sections: HTMLElement[] = [];
  examples.forEach((example, at) => {
    const before = examples[at - 1];
    if (!before || example.figure !== before.figure || !example.goals !== !before.goals) {
      const heading = example.goals ? LESSONS : headingOf(example.figure, at === 0);
      sections.push(section(heading, `heading-${at}`));
    }
    const made = card(
      example,
      results.find(({ id }) => id === example.id),
    );
    const place = sections[sections.length - 1];
    place.lastElementChild?.append(made);
    const { title, summary, statement, kinds, id } = example;
    const labels = kinds.flatMap((one) => [one.id, one.label]);
    const heading = place.firstElementChild?.textContent ?? '';
    const words = [id, title, summary, statement, heading, ...labels].join(' ').toLowerCase();
    entries.push({ example, words, card: made, section: place });
  });
  byId('cards').replaceChildren(...sections);
  return entries;
}

function section(heading: string, id: string) {
  return element(
    'section',
    { 'aria-labelledby': id },
    element('h2', { id }, heading),
    element('div.grid'),
  );
}

/** Shows the entries that match all words, the figure and the constraint. */
function show(entries: Entry[]) {
  const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = ({ example, words: text }: Entry) =>
    words.every((word) => text.includes(word)) &&
    (figure.value === '' || String(example.figure) === figure.value) &&
    (kind.value === '' || example.kinds.some(({ id }) => id === kind.value));
  for (const entry of entries) entry.card.hidden = !fits(entry);
  for (const { section } of entries) {
    section.hidden = !entries.some((other) => other.section === section && !other.card.hidden);
  }
  const found = entries.filter((entry) => !entry.card.hidden).length;
  byId('found').textContent =
    found > 0 ? count(found, 'example') : 'No example matches. Remove a word or choose All.';
}

/** @param choices value and text of each */
function offer(place: HTMLSelectElement, all: string, choices: [string, string][]) {
  const options = [['', all], ...choices];
  place.replaceChildren(...options.map(([value, text]) => element('option', { value }, text)));
}

function figuresOf(examples: Example[]): [string, string][] {
  const numbers = [
    ...new Set(examples.flatMap((one) => (one.figure === null ? [] : [one.figure]))),
  ];
  return numbers.map((number) => [String(number), headingOf(number, false)]);
}

function kindsOf(examples: Example[]): [string, string][] {
  const labels = new Map(examples.flatMap((one) => one.kinds).map(({ id, label }) => [id, label]));
  return [...labels].sort(([, a], [, b]) => a.localeCompare(b));
}

/** @param isFirst whether the section is the first one */
function headingOf(figure: number | null, isFirst: boolean) {
  if (figure === null) return isFirst ? 'To begin with' : 'Limits and other uses';
  const title = TITLES[figure];
  return title ? `Figure ${figure}: ${title}` : `Figure ${figure}`;
}
