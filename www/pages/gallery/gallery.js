/** The gallery: all examples by figure, filtered by words, figure and constraint. */

import { byId, element } from '../../ui/dom.js';
import { listOfExamples } from '../../solver/examples.js';
import { count } from '../../ui/format.js';
import { messageOf } from '../../solver/messages.js';
import { card } from './card.js';
import { LESSONS, headingOf } from './figures.js';

/** @typedef {import("../../solver/examples.js").Example} Example */
/** @typedef {{ example: Example, words: string, card: HTMLElement, section: HTMLElement }} Entry */

const RESULTS = new URL(/* @vite-ignore */ 'pictures/results.json', document.baseURI);

/** @type {HTMLInputElement} */
const query = byId('query');
/** @type {HTMLSelectElement} */
const figure = byId('figure');
/** @type {HTMLSelectElement} */
const kind = byId('kind');

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

/** @returns {Promise<import("./card.js").Result[]>} */
async function measured() {
  const response = await fetch(RESULTS);
  if (!response.ok)
    throw new Error(
      `The measurements of the gallery could not be loaded (HTTP ${response.status}).`,
    );
  return response.json();
}

/**
 * Builds a section for each figure, in the order of the examples.
 * @param {Example[]} examples
 * @param {import("./card.js").Result[]} results
 * @returns {Entry[]}
 */
function build(examples, results) {
  /** @type {Entry[]} */
  const entries = [];
  /** @type {HTMLElement[]} */
  const sections = [];
  examples.forEach((example, at) => {
    const before = examples[at - 1];
    if (!before || example.figure !== before.figure || !example.goals !== !before.goals) {
      const after = before ? (before.goals ? 'lesson' : 'figure') : 'first';
      const heading = example.goals ? LESSONS : headingOf(example.figure, after);
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

/**
 * @param {string} heading
 * @param {string} id
 */
function section(heading, id) {
  return element(
    'section',
    { 'aria-labelledby': id },
    element('h2', { id }, heading),
    element('div.grid'),
  );
}

/**
 * Shows the entries that match all words, the figure and the constraint.
 * @param {Entry[]} entries
 */
function show(entries) {
  const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = (/** @type {Entry} */ { example, words: text }) =>
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

/**
 * @param {HTMLSelectElement} place
 * @param {string} all
 * @param {[string, string][]} choices value and text of each
 */
function offer(place, all, choices) {
  const options = [['', all], ...choices];
  place.replaceChildren(...options.map(([value, text]) => element('option', { value }, text)));
}

/**
 * @param {Example[]} examples
 * @returns {[string, string][]}
 */
function figuresOf(examples) {
  const numbers = [
    ...new Set(examples.flatMap((one) => (one.figure === null ? [] : [one.figure]))),
  ];
  return numbers.map((number) => [String(number), headingOf(number, 'figure')]);
}

/**
 * @param {Example[]} examples
 * @returns {[string, string][]}
 */
function kindsOf(examples) {
  const labels = new Map(examples.flatMap((one) => one.kinds).map(({ id, label }) => [id, label]));
  return [...labels].sort(([, a], [, b]) => a.localeCompare(b));
}
