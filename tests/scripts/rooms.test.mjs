// The rooms of the page: their imports, free of cycles, and their number of files.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import { test } from 'node:test';
import { ESLint } from 'eslint';
import { at } from '../../.scripts/project.mjs';
import { APART, CONTEXT, MOST_FILES, ROOMS, TYPES } from '../../.scripts/rooms.mjs';

const WWW = at('www');
const ROOM_NAMES = Object.keys(ROOMS);

/** The files of the rooms, as paths in `www/`. */
const files = ROOM_NAMES.flatMap((room) =>
  readdirSync(join(WWW, room), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(WWW, join(entry.parentPath, entry.name)).split(sep).join('/')),
);
const scripts = files.filter((file) => /\.tsx?$/.test(file));

const IMPORT = /(?:^(?:im|ex)port (?!type\b)[^;]*?|\bimport\()'(\.[^']+)'/gm;
const TYPE = /^(?:im|ex)port type [^;]*? from '(\.[^']+)';/gm;

/** The paths in `www/` that a script names. */
const named = (file, pattern) =>
  [...readFileSync(join(WWW, file), 'utf8').matchAll(pattern)].map(([, name]) =>
    join(dirname(file), name).split(sep).join('/'),
  );

/** The room of a file, and its part if the parts of the room are separate. */
function placeOf(file) {
  const [room, part] = file.split('/');
  return { room, part: APART.includes(room) ? part.replace(/\.\w+$/, '') : '' };
}

const isOfRoom = (file) => ROOM_NAMES.includes(placeOf(file).room);

/** Whether a file may refer to another one in a room. */
function may(from, to, beyond = []) {
  const [a, b] = [placeOf(from), placeOf(to)];
  if (a.room === b.room) return a.part === b.part;
  return ROOMS[a.room].includes(b.room) || beyond.includes(b.room);
}

test('each room depends only on rooms below it', () => {
  ROOM_NAMES.forEach((room, i) => {
    const higher = ROOMS[room].filter((other) => ROOM_NAMES.indexOf(other) >= i);
    assert.deepEqual(higher, [], room);
  });
});

test('a file imports only from its own room or from rooms that it may use', () => {
  const wrong = scripts.flatMap((file) =>
    named(file, IMPORT)
      .filter((to) => isOfRoom(to) && !may(file, to))
      .map((to) => `${file} imports ${to}`),
  );
  assert.deepEqual(wrong, []);
});

test('the types that a file names come from rooms that it may use or from the context', () => {
  const wrong = scripts.flatMap((file) =>
    named(file, TYPE)
      .filter((to) => isOfRoom(to) && to !== CONTEXT && !may(file, to, TYPES[placeOf(file).room]))
      .map((to) => `${file} names a type of ${to}`),
  );
  assert.deepEqual(wrong, []);
  assert.doesNotMatch(
    readFileSync(join(WWW, CONTEXT), 'utf8'),
    /^(export )?(const|let|function|class) /m,
    `${CONTEXT} has only types`,
  );
});

test('there are no import cycles', () => {
  const done = new Set();
  const walk = (file, path) => {
    assert.ok(!path.includes(file), `a cycle: ${[...path, file].join(' -> ')}`);
    if (done.has(file)) return;
    // Files written by the build are in no room and import none; a fresh clone lacks them.
    for (const to of named(file, IMPORT)) if (scripts.includes(to)) walk(to, [...path, file]);
    done.add(file);
  };
  for (const file of scripts) if (isOfRoom(file)) walk(file, []);
});

test('no folder has more files than the limit', () => {
  const count = new Map();
  for (const file of files) count.set(dirname(file), (count.get(dirname(file)) ?? 0) + 1);
  const full = [...count].filter(([, inside]) => inside > MOST_FILES);
  assert.deepEqual(full, []);
});

test('the linter refuses code that breaks the rules of the rooms', async () => {
  const linter = new ESLint({
    cwd: at(),
    overrideConfigFile: at('.scripts', 'eslint.config.mjs'),
    // Where CI is set, the parser reads each file from disk instead of taking the code it is given.
    overrideConfig: {
      files: ['www/**/*.{ts,tsx}'],
      languageOptions: { parserOptions: { disallowAutomaticSingleRunInference: true } },
    },
  });
  const rulesBroken = async (file, code) => {
    const [{ messages }] = await linter.lintText(code, { filePath: at('www', file) });
    return messages.map(({ ruleId }) => ruleId).filter((rule) => /no-restricted/.test(rule));
  };
  const imports = ['@typescript-eslint/no-restricted-imports'];
  const later = ['no-restricted-syntax'];
  for (const [file, code, broken] of [
    ['ui/dom.ts', "import '../store/state.ts';", imports],
    ['store/state.ts', "import '../app/main.ts';", imports],
    ['panels/constraints/constraints.tsx', "import '../legend/legend.tsx';", imports],
    ['panels/example.tsx', "import '../features/hints.tsx';", imports],
    ['features/hints.tsx', "import './help/help.tsx';", imports],
    ['features/lesson/dialog.tsx', "import('../share/dialog-share.tsx');", later],
    ['viewport/viewport.ts', "import('../features/split/split.ts');", later],
    [
      'panels/constraints/constraints.tsx',
      "import '../../store/state.ts'; import './details.tsx';",
      [],
    ],
    ['app/main.ts', "import('../features/hints.tsx');", []],
    ['panels/example.tsx', 'export const f = (store: any) => store.set({});', later],
    ['panels/example.tsx', 'export const f = (it) => it.solver.tell.pause();', later],
    ['store/actions.ts', 'export const f = (solver) => solver.change.undo();', []],
  ])
    assert.deepEqual(await rulesBroken(file, code), broken, `${file}: ${code}`);
});
