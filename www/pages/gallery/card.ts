/** A card of the gallery: pictures of start and end, a summary, and the measured results. */

import { element, svgElement } from '../../ui/dom.ts';
import { linkToExample } from '../../solver/examples.ts';
import { count, number as energyInWords, part } from '../../ui/words.ts';
import type { Example } from '../../solver/examples.ts';

/** An entry of `pictures/results.json`. */
export interface Result {
  id: string;
  iterations: number;
  /** total energy at the start and at the end */
  energy?: [number, number];
  /** of corners, at the start and at the end */
  angles?: [number[], number[]];
}

const PICTURES = new URL(/* @vite-ignore */ 'pictures/', document.baseURI);

export function card(example: Example, result: Result | undefined) {
  const { id, title, summary, statement, kinds, weights, goals = [] } = example;
  // Without constraints, the example is one to flatten.
  const isMap = kinds.length === 0;
  const picture = (when: 'start' | 'end', words: string) =>
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
    element('h3', { id: `${id}-title` }, element('a', { href: `./${linkToExample(id)}` }, title)),
    element('p', summary),
    element('p.statement', element('strong', 'Measured: '), statement),
    result?.angles && angleHistogram(result.angles),
    element(
      'dl',
      ...goals.flatMap(({ sentence }) => fact('Goal', sentence)),
      ...(isMap ? [] : fact('Constraints', kinds.map(({ label }) => label).join(', '))),
      ...(isMap
        ? []
        : fact('Weights', `shape ${weights[0]}, close ${weights[1]}, smooth ${weights[2]}`)),
      ...fact('Mesh', sizeInWords(example)),
      ...(result?.energy ? fact('Energy', energyFall(result.energy, result.iterations)) : []),
    ),
  );
}

function fact(name: string, value: string) {
  return [element('dt', name), element('dd', value)];
}

function sizeInWords({ vertices, faces, tets }: Example) {
  const parts = [
    vertices && count(vertices, 'vertex', 'vertices'),
    faces && count(faces, 'face'),
    tets && count(tets, 'tetrahedron', 'tetrahedra'),
  ];
  return parts.filter(Boolean).join(', ');
}

function energyFall(energy: [number, number], iterations: number) {
  const [before, after] = energy.map(energyInWords);
  return `${before} → ${after} in ${iterations} iterations`;
}

/** Size of a histogram. */
const [WIDTH, HEIGHT] = [180, 46];

/**
 * Histograms of the angles at the corners.
 * @param counts of corners in bins of equal width from 0 to 180 degrees, at the
 *   start and at the end
 */
function angleHistogram([before, after]: [number[], number[]]) {
  const most = Math.max(...before, ...after);
  return element(
    'div.angles',
    histogram('Angles at the start', before, most),
    histogram('Angles when solved', after, most),
  );
}

/** @param most maximum of both */
function histogram(title: string, counts: number[], most: number) {
  const width = 180 / counts.length;
  const total = counts.reduce((sum, count) => sum + count, 0);
  // Bins whose centre is within 10 degrees of a right angle.
  const right = counts.filter((_, k) => Math.abs((k + 0.5) * width - 90) < 10);
  const share = part(right.reduce((sum, count) => sum + count, 0) / total);
  const bars = counts.map((count, k) => {
    const height = (HEIGHT * count) / most;
    const x = (k * WIDTH) / counts.length;
    return svgElement('rect', {
      x,
      y: HEIGHT - height,
      width: WIDTH / counts.length - 0.6,
      height,
    });
  });
  const words = `${title}: ${share} are within 10 degrees of 90 degrees`;
  const attributes = { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': words };
  const svg = svgElement('svg', attributes, ...bars);
  const ends = ['0°', '90°', '180°'].map((text) => element('span', text));
  return element(
    'figure',
    svg,
    element('div.ends', { 'aria-hidden': 'true' }, ...ends),
    element('figcaption', `${title}: ${share} near 90°`),
  );
}
