// The page of licences: the shipped components with their licence texts.

import { readFileSync } from 'node:fs';
import { at } from './project.mjs';
import { licencesOf, shipped, textsOf } from './licences.mjs';
import { sourceOf } from './sources.mjs';

/** A text within HTML. */
export const escaped = (text) =>
  text.replace(/[&<>]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign]);

/** Groups components with the same licence text. */
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

/** Returns the components and texts without mark-up. */
export function licencesInText() {
  const section = ({ text, members }) => {
    const names = members.map(({ name, version }) => `${name} ${version}`).join(', ');
    return `${licencesOf(members[0]).join(' and ')}: ${names}\n\n${text}`;
  };
  return `${byText(shipped())
    .map(section)
    .join(`\n\n${'-'.repeat(72)}\n\n`)}\n`;
}

/** Inserts the components and texts into the template of the page. @param {string} html */
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
