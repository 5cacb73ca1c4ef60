// Tests that only `npm run test:long` runs, which the workflow of the repository does every night:
// those that tell a story of another test once more, in another window or for another fault of the
// same kind, and the slowest that compare pictures. What holds the story in between is named.

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
    titles: ['around the view', 'new panels'].map((walk) => `axe: ${walk}`),
    heldBy: 'the same walks on the desktop, and the other walks on a phone',
  },
  {
    spec: 'axe',
    project: 'phone',
    titles: [
      'the gallery',
      'the page “What is checked”',
      'the page “From Rhino and Grasshopper”',
      'the page “For teachers”',
      'an embedded view',
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
    titles: ['the first picture is removed'],
    heldBy: 'the same on the desktop',
  },
  {
    spec: 'backends',
    titles: ['no device', 'an adapter that never answers'].map(
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
    heldBy: 'two tabs do not overwrite each other; tests/page/documents/recent-documents.test.ts',
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
    titles: ['residuals are arrows'],
    heldBy: 'nothing in between: it compares pictures for ten seconds',
  },
  {
    spec: 'circles',
    titles: ['circles are thin lines from near'],
    heldBy: 'nothing in between: it compares pictures for fifteen seconds',
  },
];

/** Matches what Playwright tests a pattern with: project, file and title, separated by spaces. */
const patternOf = ({ spec, titles, project }: Group) => {
  const escaped = titles.map((title) => title.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`));
  return new RegExp(`^${project ?? ''}.*\\b${spec}\\.spec\\.ts (${escaped.join('|')})`);
};

/** Returns the patterns of tests that are left out of a project beside its own. */
export const leftOut = (...own: RegExp[]) => (LONG ? own : [...own, ...NIGHTLY.map(patternOf)]);
