/** List of the examples, and their links. */

import type { LessonWords } from '../pkg/engine/shape_up.js';

/** An entry of `examples/index.json`, as the command line writes it. */
export interface Example {
  id: string;
  /** number in the paper */
  figure: number | null;
  title: string;
  /** what to look for */
  summary: string;
  /** result measured when it is solved */
  statement: string;
  /** file name */
  scene: string;
  /** file name */
  mesh: string;
  vertices: number;
  faces: number;
  tets: number;
  kinds: { id: string; label: string }[];
  /** shape, close, smooth */
  weights: [number, number, number];
  plots: Plot[];
  /** goals of a lesson */
  goals?: LessonWords['goals'];
  /** of the mesh */
  units: string;
}

/** A plot worth looking at: the label of its button, and the id of its tab. */
type Plot = { label: string; plot: string };

const LIST = new URL(/* @vite-ignore */ 'examples/index.json', document.baseURI);

/** @throws if there is none with this id */
export function exampleOf(examples: Example[], id: string) {
  const example = examples.find((one) => one.id === id);
  if (!example)
    throw new Error(`There is no example called ${id}. The link is outdated or mistyped.`);
  return example;
}

/** @returns in the order of the figures */
export async function listOfExamples(): Promise<Example[]> {
  const response = await fetch(LIST).catch(() => {
    throw new Error('The list of examples could not be fetched. Check the network.');
  });
  if (!response.ok)
    throw new Error(`The list of examples could not be fetched (${response.status}).`);
  return response.json();
}

/** Returns the permanent fragment of an example, see `documents/share-link.ts`. */
export const linkToExample = (id: string) => `#example=${id}`;
