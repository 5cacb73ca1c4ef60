/** The examples: the list of them, the menu, and the links that open one. */

import { element } from './dom.js';
import { exampleNamed, nameInAddress } from './example-links.js';
import { removeFirstPicture } from './first-picture.js';
import { messageOf } from './messages.js';

/**
 * An entry of `examples/index.json`, as the command line writes it.
 * @typedef {object} Example
 * @property {string} id
 * @property {number | null} figure of the paper
 * @property {string} title
 * @property {string} summary what to look for
 * @property {string} statement what is measured when it is solved
 * @property {string} scene name of its file
 * @property {string} mesh name of its file
 * @property {number} vertices
 * @property {number} faces
 * @property {number} tets
 * @property {{ id: string, label: string }[]} kinds
 * @property {[number, number, number]} weights shape, close, smooth
 */

const FOLDER = new URL(/* @vite-ignore */ 'examples/', document.baseURI);

/** @returns {Promise<Example[]>} in the order of the figures */
export async function listOfExamples() {
  return JSON.parse(new TextDecoder().decode(await fetched('index.json')));
}

/**
 * The files of an example.
 * @param {Example} example
 * @returns {Promise<import("./messages.js").NamedBytes[]>}
 */
export function filesOf({ scene, mesh }) {
  return Promise.all([scene, mesh].map(async (name) => ({ name, bytes: await fetched(name) })));
}

/**
 * Fills the menu, opens what the address names, else the first example, and follows the address
 * from then on.
 * @param {HTMLElement} menu
 * @param {import("./files.js").Files} files
 * @param {import("./alerts.js").Alerts} alerts
 */
export async function offerExamples(menu, files, alerts) {
  const named = () => exampleNamed(location.hash);
  if (named() !== null) removeFirstPicture();
  const examples = await listOfExamples();

  /** @param {Example} example */
  const open = async (example) => {
    const at = examples.indexOf(example);
    const beside = { previous: examples[at - 1] ?? null, next: examples[at + 1] ?? null };
    try {
      await files.openExample(example, beside);
      nameInAddress(example.id);
    } catch (error) {
      alerts.error(messageOf(error));
    }
  };
  const complain = (/** @type {string} */ id) =>
    alerts.error(`There is no example “${id}”. The gallery shows those that there are.`);
  const find = (/** @type {string | null} */ id) => examples.find((example) => example.id === id);

  const entries = examples.map((example) => {
    const onclick = () => {
      menu.hidePopover();
      open(example);
    };
    return element(
      'button',
      { type: 'button', role: 'menuitem', onclick },
      entry(example.title, example.summary),
    );
  });
  const gallery = element(
    'a',
    { role: 'menuitem', href: './gallery.html' },
    entry('Gallery', 'All examples with pictures of their start and end, figure by figure.'),
  );
  menu.replaceChildren(gallery, ...entries);

  window.addEventListener('hashchange', () => {
    const id = named();
    const example = find(id);
    if (example) open(example);
    else if (id !== null) complain(id);
  });

  const id = named();
  const example = find(id);
  if (example) return open(example);
  const [first, next] = examples;
  await files.openExample(first, { previous: null, next }, true);
  if (id !== null) complain(id);
}

/**
 * @param {string} title
 * @param {string} text
 */
function entry(title, text) {
  const parts = [element('strong', {}, title), element('span', {}, text)];
  return element('span', { class: 'entry' }, ...parts);
}

/**
 * @param {string} name of a file among the examples
 * @returns {Promise<Uint8Array>}
 */
async function fetched(name) {
  const response = await fetch(new URL(name, FOLDER));
  if (!response.ok)
    throw new Error(`The example file ${name} could not be fetched (${response.status}).`);
  return new Uint8Array(await response.arrayBuffer());
}
