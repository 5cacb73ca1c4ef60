/** List of the examples. */

/**
 * An entry of `examples/index.json`, as the command line writes it.
 * @typedef {object} Example
 * @property {string} id
 * @property {number | null} figure number in the paper
 * @property {string} title
 * @property {string} summary what to look for
 * @property {string} statement result measured when it is solved
 * @property {string} scene file name
 * @property {string} mesh file name
 * @property {number} vertices
 * @property {number} faces
 * @property {number} tets
 * @property {{ id: string, label: string }[]} kinds
 * @property {[number, number, number]} weights shape, close, smooth
 * @property {Experiment | null} experiment comparison of methods on it
 * @property {Suggestion[]} suggestions displays worth looking at
 * @property {import("./messages.js").LessonWords["goals"]} [goals] goals of a lesson
 * @property {string} units of the mesh
 */

/**
 * A comparison of methods, as declared in the list of examples.
 * @typedef {object} Experiment
 * @property {string} id
 * @property {string} label
 * @property {string} summary
 * @property {{ id: string, label: string, unit: "energy" | "length" | "none" }[]} quantities
 * @property {{ quantity: number, over: "iterations" | "seconds", above_lowest: boolean }[]} plots
 * @property {{ id: string, label: string, summary: string }[]} methods
 * @property {{ iterations: number, seconds: number }} limits of each method
 */

/**
 * Content of a side of the split view.
 * @typedef {{ measure: import("./messages.js").Measure, original: boolean }} SideChoice
 */

/**
 * A suggested display: two pictures side by side, or the name of a plot.
 * @typedef {{ label: string, shows: { split?: [SideChoice, SideChoice], plot?: string } }} Suggestion
 */

const LIST = new URL(/* @vite-ignore */ 'examples/index.json', document.baseURI);

/** @returns {Promise<Example[]>} in the order of the figures */
export async function listOfExamples() {
  const response = await fetch(LIST).catch(() => {
    throw new Error('The list of examples could not be fetched. Check the network.');
  });
  if (!response.ok)
    throw new Error(`The list of examples could not be fetched (${response.status}).`);
  return response.json();
}
