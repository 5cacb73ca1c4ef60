// The rooms of the page, `www/`: which may import which. The linter and
// tests/scripts/rooms.test.mjs enforce it.

/** The rooms that each may import, from the lowest to the highest. */
export const ROOMS = {
  ui: [],
  solver: [],
  worker: ['solver'],
  store: ['ui', 'solver'],
  viewport: ['ui', 'solver', 'store'],
  documents: ['ui', 'solver', 'store', 'viewport'],
  panels: ['ui', 'solver', 'store', 'viewport', 'documents'],
  docked: ['ui', 'store'],
  features: ['ui', 'solver', 'store', 'viewport', 'documents', 'docked'],
  app: ['ui', 'solver', 'store', 'viewport', 'documents', 'panels', 'docked', 'features'],
  pages: ['ui', 'solver', 'store', 'documents', 'features'],
};

/** Rooms whose parts are independent of each other: a part is a subfolder, or a file with its styles. */
export const APART = ['features', 'panels'];

/** Largest number of files of a folder. */
export const MOST_FILES = 25;

/** Rooms whose types a room may name beyond what it may import. */
export const TYPES = { ui: ['solver'], solver: ['worker'] };

/** This file has only types, which the highest room provides: any room may name them. */
export const CONTEXT = 'app/context.ts';

const own = ({ message, regex }, files, room) => {
  const source = regex.replaceAll('/', '\\/');
  return {
    files,
    rules: {
      '@typescript-eslint/no-restricted-imports': [
        'error',
        { patterns: [{ regex, message, allowTypeImports: true }] },
      ],
      'no-restricted-syntax': [
        'error',
        ...STYLES,
        ...(BY_ACTIONS.includes(room) ? ACTS : []),
        { selector: `ImportExpression[source.value=/${source}/]`, message },
      ],
    },
  };
};

/** The attribute `style`, which the page's content security policy forbids. */
const STYLES = ['name', 'property.name'].map((name) => ({
  selector: `CallExpression[callee.${name}=/^setAttribute$/] > Literal[value='style']`,
  message: 'The policy of the page refuses the attribute: set element.style.',
}));

/** Rooms that change the state or call the solver through actions only. */
export const BY_ACTIONS = ['viewport', 'documents', 'panels', 'features'];

/** What writes the state or changes what the solver has. */
const ACTS = [
  ['store', 'set'],
  ['solver', 'change|tell'],
].flatMap(([what, methods]) =>
  ['name', 'property.name'].map((name) => ({
    selector: `MemberExpression[object.${name}=${what}][property.name=/^(${methods})$/]`,
    message: `Only actions do this: see www/store/actions.ts.`,
  })),
);

/** The linter's rules for the rooms. */
export const roomRules = Object.entries(ROOMS).flatMap(([room, lower]) => {
  const others = Object.keys(ROOMS).filter((other) => other !== room && !lower.includes(other));
  const may =
    lower.length > 0 ? `may import from ${lower.join(', ')}` : 'imports from no other room';
  const outside = {
    regex: `^(\\.\\./)+(${others.join('|')})/`,
    message: `${room}/ ${may}: see .scripts/rooms.mjs.`,
  };
  if (!APART.includes(room)) return [own(outside, [`www/${room}/**/*.{ts,tsx}`], room)];
  const message = `${outside.message} What is beside it is another part of the page.`;
  return [
    own(
      { regex: `${outside.regex}|^\\./(?!.*\\.css$)`, message },
      [`www/${room}/*.{ts,tsx}`],
      room,
    ),
    own({ regex: `${outside.regex}|^\\.\\./[^.]`, message }, [`www/${room}/*/**/*.{ts,tsx}`], room),
  ];
});
