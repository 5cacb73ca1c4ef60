// Tests that only `npm run test:long` runs, which the workflow of the repository does every night:
// those that tell a story of another test once more, in another window, for another fault of the
// same kind. What holds that story in between is named.

/** Whether tests that can go on for long do so. */
export const LONG = process.env.LONG === '1';

/** A group of tests, by the spec and how the titles begin, and what holds their story every time. */
interface Group {
  spec: string;
  titles: string[];
  heldBy: string;
  /** Only in this window, if present. */
  project?: 'phone';
}

export const NIGHTLY: Group[] = [
  {
    spec: 'axe',
    project: 'phone',
    titles: ['around the view', 'new panels', 'other examples', 'what opens from the tools'].map(
      (walk) => `axe: ${walk}`,
    ),
    heldBy: 'the same walks on the desktop, and the other walks on a phone',
  },
  {
    spec: 'axe',
    project: 'phone',
    titles: [
      ...['the gallery', 'the page about projections', 'an embedded view'],
      ...['the page “What is checked', 'the page “From Rhino'],
    ].map((page) => `axe: ${page}`),
    heldBy: 'the same pages on the desktop',
  },
  {
    spec: 'first-visit',
    project: 'phone',
    titles: ['hints follow another order', 'Undo and Reset lead', 'the examples menu opens'],
    heldBy: 'the same visits on the desktop, and the first minute on a phone',
  },
  {
    spec: 'first-picture',
    project: 'phone',
    titles: [
      'the example is on the screen before it can be drawn, dark',
      'presses made before anything has loaded',
      'the first picture is removed',
    ],
    heldBy: 'the same on the desktop, and the light picture on a phone',
  },
  {
    spec: 'first-picture',
    titles: ['in a window of other proportions'],
    heldBy: 'the picture of the example on the desktop and on a phone',
  },
  {
    spec: 'backends',
    titles: ['an adapter that never answers', 'no device', 'pictures that stay empty'].map(
      (fault) => `WebGL2 draws if WebGPU has ${fault}`,
    ),
    heldBy: 'no adapter, before the module of WebGPU is loaded, and a lost device, after it',
  },
  {
    spec: 'autosave',
    titles: ['reload', 'leave'].map((way) => `an edit is kept when followed at once by: ${way}`),
    heldBy: 'the same when the page is closed',
  },
  {
    spec: 'autosave',
    titles: ['two tabs reloaded at the same moment', 'with storage full'],
    heldBy: 'two tabs do not overwrite each other; with storage blocked the page works',
  },
  {
    spec: 'replacing',
    titles: ['names nothing', 'is empty'].map((what) => `an address that ${what} leaves the open`),
    heldBy: 'an address that is damaged leaves the open work',
  },
  {
    spec: 'gallery',
    titles: [1, 2, 3].map((part) => `examples open one after another, part ${part} of`),
    heldBy: 'part 4, and the native tests that solve every example',
  },
  {
    spec: 'colours',
    titles: ['choosing a measure again', 'residuals are arrows'],
    heldBy: 'the colours of measures and constraints, and the native tests of residuals',
  },
  {
    spec: 'circles',
    titles: ['circles are thin lines from near'],
    heldBy: 'the native tests of the lines of circles, and the picture of the example',
  },
];

/** Matches what Playwright tests a pattern with: project, file and title, separated by spaces. */
export const patternOf = ({ spec, titles, project }: Group) => {
  const escaped = titles.map((title) => title.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`));
  return new RegExp(`^${project ?? ''}.*\\b${spec}\\.spec\\.ts (${escaped.join('|')})`);
};

/** Returns the patterns of tests that are left out of a project beside its own. */
export const leftOut = (...own: RegExp[]) => (LONG ? own : [...own, ...NIGHTLY.map(patternOf)]);
