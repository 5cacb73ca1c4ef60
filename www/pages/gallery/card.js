/** A card of the gallery: pictures of start and end, a summary, and the measured results. */

import { element } from '../../ui/dom.js';
import { linkTo } from '../../documents/example-links.js';
import { number as energyInWords } from '../../ui/format.js';
import { goalInWords } from '../../features/lesson/goal.js';
import { angleHistogram } from './angles.js';
import { withSymbols } from '../../ui/symbols.js';

/**
 * An entry of `pictures/results.json`.
 * @typedef {object} Result
 * @property {string} id
 * @property {number} iterations
 * @property {[number, number]} [energy] total energy at the start and at the end
 * @property {[number[], number[]]} [angles] of corners, at the start and at the end
 */

const PICTURES = new URL(/* @vite-ignore */ 'pictures/', document.baseURI);

/**
 * @param {import("../../solver/examples.js").Example} example
 * @param {Result | undefined} result
 */
export function card(example, result) {
  const { id, title, summary, statement, kinds, weights, goals = [], units } = example;
  // Without constraints, the example is one to flatten.
  const isMap = kinds.length === 0;
  const picture = (/** @type {"start" | "end"} */ when, /** @type {string} */ words) =>
    element(
      'figure',
      element('img', {
        src: new URL(`${id}-${when}.webp`, PICTURES).href,
        alt: `${title}, ${words}`,
        width: 216,
        height: 156,
        loading: 'lazy',
      }),
      element('figcaption', when === 'start' ? 'Start' : isMap ? 'Flat map' : 'Solved'),
    );
  return element(
    'article.example',
    { id, 'aria-labelledby': `${id}-title` },
    element(
      'div.pictures',
      picture('start', 'at the start'),
      picture('end', isMap ? 'as a flat map' : 'solved'),
    ),
    element('h3', { id: `${id}-title` }, element('a', { href: `./${linkTo(id)}` }, title)),
    element('p', summary),
    element('p.statement', element('strong', 'Measured: '), ...withSymbols(statement)),
    result?.angles && angleHistogram(result.angles),
    element(
      'dl',
      ...goals.flatMap((goal) => fact('Goal', goalInWords(goal, units))),
      ...(isMap ? [] : fact('Constraints', kinds.map(({ label }) => label).join(', '))),
      ...(isMap
        ? []
        : fact('Weights', `shape ${weights[0]}, close ${weights[1]}, smooth ${weights[2]}`)),
      ...fact('Mesh', sizeInWords(example)),
      ...(result?.energy ? fact('Energy', energyFall(result.energy, result.iterations)) : []),
    ),
  );
}

/**
 * @param {string} name
 * @param {string} value
 */
function fact(name, value) {
  return [element('dt', name), element('dd', value)];
}

/** @param {import("../../solver/examples.js").Example} example */
function sizeInWords({ vertices, faces, tets }) {
  const parts = [
    [vertices, 'vertices'],
    [faces, 'faces'],
    [tets, 'tetrahedra'],
  ];
  const words = parts.filter(([count]) => count).map(([count, name]) => `${count} ${name}`);
  return words.join(', ');
}

/**
 * @param {[number, number]} energy
 * @param {number} iterations
 */
function energyFall(energy, iterations) {
  const [before, after] = energy.map(energyInWords);
  return `${before} → ${after} in ${iterations} iterations`;
}
