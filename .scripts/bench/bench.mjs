// npm run bench: the speed of the solver, natively and in headless Chromium, compared with other
// libraries. `npm run bench -- --help` lists the options.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { build as buildSite } from '../build.mjs';
import { at } from '../project.mjs';
import { main, outputOf, Problem, say } from '../run.mjs';
import { setUp } from '../setup.mjs';
import { startBrowser } from './browser.mjs';
import { startNative } from './native.mjs';
import { casesOf, measured, parts, tablesOf, textsOf } from './parts.mjs';
import { benchFolder, letters } from './problems.mjs';
import { isQuiet, otherLoad, otherLoadText } from './quiet.mjs';
import { writeNumbers } from './readme.mjs';
import { table } from './tables.mjs';

const usual = ['iterations', 'maps', 'convergence', 'start'];

const usage = `npm run bench -- [options]

  --sizes N,N      vertices of the meshes (default depends on the part), from 36 on
  --problems A,B   of ${letters} (default all but E: A with boundary curves and a trace)
  --parts P,P      of ${Object.keys(parts)} (default ${usual})
  --where W,W      of native, browser (default both)
  --full           all sizes and parts
  --trial          check that it works, with what has been built for the tests
  --write          write the tables of src/solve/performance.md and the numbers of the README, on a
                   quiet machine

Writes target/bench/bench.md and target/bench/bench.json.`;

const declared = {
  sizes: { type: 'string' },
  problems: { type: 'string', default: 'A,B,C,D' },
  parts: { type: 'string' },
  where: { type: 'string', default: 'native,browser' },
  ...{ full: { type: 'boolean' }, trial: { type: 'boolean' } },
  ...{ write: { type: 'boolean' }, help: { type: 'boolean' } },
};

/** What may be in the lists. */
const isGood = {
  sizes: (word) => Number(word) >= 36,
  problems: (word) => letters.includes(word),
  parts: (word) => word in parts,
  where: (word) => ['native', 'browser'].includes(word),
};

/** Returns the options given by the arguments. */
export function optionsOf(args) {
  try {
    const { values } = parseArgs({ args, options: declared });
    for (const name of Object.keys(isGood)) {
      values[name] = values[name]?.split(',');
      const strange = values[name]?.find((word) => !isGood[name](word));
      if (strange !== undefined) throw new Problem(`--${name} ${strange}: not known`);
    }
    // The documentation has all tables, of measurements in all places.
    const isWhole = values.full && args.every((word) => ['--full', '--write'].includes(word));
    if (values.write && !isWhole) throw new Problem('--write: only with --full, and nothing else');
    const chosen = values.full ? Object.keys(parts) : usual;
    return { ...values, sizes: values.sizes?.map(Number), parts: values.parts ?? chosen };
  } catch (error) {
    throw new Problem(`${error.message}\n\n${usage}`);
  }
}

/** Builds what is measured, and starts the places that the options name. */
async function begin({ where, trial }) {
  const places = {};
  if (where.includes('browser') && !trial) {
    await setUp({ checks: true });
    await buildSite();
  }
  if (where.includes('native')) places.native = await startNative(trial);
  if (where.includes('browser')) places.browser = await startBrowser(trial);
  return places;
}

/** Measures all cases of a part; a failure leaves the other rows, which took long. */
async function rowsOf(name, options, on) {
  const rows = [];
  for (const one of casesOf(name, options)) {
    say(
      [name, one.peer?.library, one.problem ?? one.surface, one.size ?? one.panels]
        .filter(Boolean)
        .join(', '),
    );
    try {
      const found = [await measured(name, one, options.where, on)].flat();
      rows.push(...found.map((values) => ({ ...one, ...values })));
    } catch (error) {
      say(`failed: ${error.message}`);
      rows.push({ ...one, failed: error.message });
    }
  }
  return rows;
}

/** Refuses to write numbers of a busy machine into the documentation; they are of use otherwise. */
function requireQuiet(...moments) {
  if (moments.every(isQuiet)) return;
  throw new Problem(`${otherLoadText(...moments)} The tables are not written.`);
}

/** Describes the command, and what it ran on. */
function machineText(words, browser) {
  const command = ['npm run bench', ...(words.length ? ['--', ...words] : [])].join(' ');
  const commit = outputOf('git', ['rev-parse', '--short', 'HEAD']);
  const date = new Date().toISOString().slice(0, 10);
  const processor = `one of the ${cpus().length} cores of an ${cpus()[0].model}`;
  const on = [processor, browser, outputOf('rustc', ['--version'])].filter(Boolean).join(', ');
  return `\`${command}\` at ${commit} on ${date}, on ${on}.`;
}

/** Returns the rows of all parts by name, and the load by others before and after. */
async function measure(options, words) {
  const moment = options.trial ? 50 : 1000;
  const places = await begin(options);
  const on = (place, ...task) => places[place].perform(...task);
  const moments = [await otherLoad(moment)];
  say(otherLoadText(...moments));
  const rows = {};
  try {
    if (options.write) requireQuiet(...moments);
    for (const name of options.parts) rows[name] = await rowsOf(name, options, on);
  } finally {
    await places.browser?.close();
  }
  moments.push(await otherLoad(moment));
  return { machine: machineText(words, places.browser?.version), moments, rows };
}

/** Returns the tables of results as text. */
function markdown({ machine, moments, rows }) {
  const texts = Object.entries(rows).flatMap(([name, all]) => [
    ...tablesOf(name)
      .map(([title, columns]) => [title, table(columns, all)])
      .filter(([, text]) => text),
    textsOf(name, all),
  ]);
  const kinds =
    'Times are medians of several runs, with the middle half of them in parentheses; "once" is a single run, of what takes long.';
  return [`${machine} ${otherLoadText(...moments)}`, kinds, ...texts.flat()].join('\n\n');
}

/** The page of the documentation that has the tables, and the lines that enclose them. */
export const page = 'src/solve/performance.md';
export const marks = [
  '<!-- speed: written by `npm run bench -- --full --write` -->\n',
  '<!-- end of speed -->\n',
];

/** Writes the tables into the page at a path, if the machine was quiet before and after. */
export function writeTables(results, path) {
  requireQuiet(...results.moments);
  const [start, end] = marks;
  const [before, rest] = readFileSync(path, 'utf8').split(start);
  const after = rest?.split(end)[1];
  if (after === undefined) throw new Problem(`${path}: the marks of the tables are gone`);
  const section = markdown(results);
  writeFileSync(path, `${before}${start}\n${section}\n\n${end}${after}`);
}

async function bench(words) {
  const options = optionsOf(words);
  if (options.help) return console.log(usage);
  const results = await measure(options, words);
  const file = join(benchFolder, options.trial ? 'trial' : 'bench');
  const text = markdown(results);
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(`${file}.json`, JSON.stringify(results, null, 1));
  writeFileSync(`${file}.md`, `# How fast it is\n\n${text}\n`);
  console.log(`\n${text}`);
  const failed = Object.values(results.rows).flatMap((all) => all.filter((row) => row.failed));
  if (failed.length) throw new Problem(`${failed.length} measurements failed, see above`);
  if (!options.write) return;
  writeTables(results, at(page));
  writeNumbers(results.rows, at('README.md'));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(() => bench(process.argv.slice(2)));
}
