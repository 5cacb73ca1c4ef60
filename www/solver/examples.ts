/** List of the examples. */

import type { LessonWords, Measure } from './messages.ts';

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
  /** comparison of methods on it */
  experiment: Experiment | null;
  /** displays worth looking at */
  suggestions: Suggestion[];
  /** goals of a lesson */
  goals?: LessonWords['goals'];
  /** of the mesh */
  units: string;
}

/** A comparison of methods, as declared in the list of examples. */
export interface Experiment {
  id: string;
  label: string;
  summary: string;
  quantities: { id: string; label: string; unit: 'energy' | 'length' | 'none' }[];
  plots: { quantity: number; over: 'iterations' | 'seconds'; above_lowest: boolean }[];
  methods: { id: string; label: string; summary: string }[];
  /** of each method */
  limits: { iterations: number; seconds: number };
}

/** Content of a side of the split view. */
type SideChoice = { measure: Measure; original: boolean };

/** A suggested display: two pictures side by side, or the name of a plot. */
export type Suggestion = {
  label: string;
  shows: { split?: [SideChoice, SideChoice]; plot?: string };
};

const LIST = new URL(/* @vite-ignore */ 'examples/index.json', document.baseURI);

/** @returns in the order of the figures */
export async function listOfExamples(): Promise<Example[]> {
  const response = await fetch(LIST).catch(() => {
    throw new Error('The list of examples could not be fetched. Check the network.');
  });
  if (!response.ok)
    throw new Error(`The list of examples could not be fetched (${response.status}).`);
  return response.json();
}
