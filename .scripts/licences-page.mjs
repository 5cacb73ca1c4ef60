// The page of licences: what is shipped, and the text under which it is.

import { readFileSync } from 'node:fs';
import { at } from './project.mjs';
import { licencesOf, shipped, textsOf } from './licences.mjs';
import { sourceOf } from './sources.mjs';

const escaped = (text) =>
  text.replace(/[&<>]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign]);

/** Components with the same text, under each. */
function byText(components) {
  const groups = new Map();
  for (const component of components) {
    const text = textsOf(component).join('\n\n');
    const key = text.replace(/\s+/g, ' ');
    const group = groups.get(key) ?? { text, members: [] };
    group.members.push(component);
    groups.set(key, group);
  }
  return [...groups.values()];
}

/** @param {{ text: string, members: import("./licences.mjs").Component[] }} group */
function section({ text, members }) {
  const list = members.map(
    ({ name, version, address }) =>
      `<li><a href="${address}">${escaped(name)}</a> ${escaped(version)}</li>`,
  );
  const licence = licencesOf(members[0]).join(' and ');
  return `<section><h3>${licence}</h3><ul>${list.join('')}</ul><details><summary>Text</summary><pre>${escaped(text)}</pre></details></section>`;
}

/** The page with all of it, from the one with the places for it. @param {string} html */
export function licenceTexts(html) {
  const components = shipped();
  const groups = byText(components);
  const library = components.find(({ name }) => name === 'sprs-ldl');
  return html
    .replaceAll('<!-- library -->', `sprs-ldl ${library.version}`)
    .replaceAll('{library source}', `./sources/${sourceOf(library)}`)
    .replace('<!-- own licence -->', () => escaped(readFileSync(at('LICENSE'), 'utf8').trim()))
    .replace('<!-- licences -->', () => groups.map(section).join('\n'));
}
