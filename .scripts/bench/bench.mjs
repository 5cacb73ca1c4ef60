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
import { nativePlace, nativeProgram } from './native.mjs';
import { parts } from './parts.mjs';
import { benchFolder, problems } from './problems.mjs';
import { isQuiet, unrest, unrestText } from './quiet.mjs';
import { table } from './tables.mjs';

const usual = Object.keys(parts).filter((part) => parts[part].usual);
const letters = Object.keys(problems).filter((name) => name.length === 1);

const usage = `npm run bench -- [options] [MESH...]

  --sizes N,N      vertices of the meshes (default 2500,10000; --full 2500,10000,30000,100000)
  --problems A,B   of ${letters} (default all but E: A with boundary curves and a trace)
  --parts P,P      of ${Object.keys(parts)} (default ${usual}; folds is on the named meshes)
  --where W,W      of native, browser (default both)
  --full           all sizes and parts
  --trial          check that it works, with what has been built for the tests
  --readme         write the tables of the README, on a quiet machine

Writes target/bench/bench.md and target/bench/bench.json.`;

const declared = {
  sizes: { type: 'string' },
  problems: { type: 'string', default: 'A,B,C,D' },
  parts: { type: 'string' },
  where: { type: 'string', default: 'native,browser' },
  ...{ full: { type: 'boolean' }, trial: { type: 'boolean' } },
  ...{ readme: { type: 'boolean' }, help: { type: 'boolean' } },
};

function listOf(name, text, known) {
  const words = text.split(',');
  const strange = words.find((word) => !known.includes(word));
  if (strange === undefined) return words;
  throw new Problem(`--${name} ${strange}: expected some of ${known.join(', ')}\n\n${usage}`);
}

function sizesOf(text) {
  const sizes = text.split(',').map(Number);
  if (sizes.every((size) => size >= 36)) return sizes;
  throw new Problem(`--sizes ${text}: expected numbers from 36 on`);
}

/** Returns the options given by the arguments. */
export function optionsOf(args) {
  try {
    const { values, positionals } = parseArgs({ args, options: declared, allowPositionals: true });
    const { full, trial, readme, help } = values;
    const all = Object.keys(parts);
    const chosen = full ? all : usual;
    return {
      // A trial is no measurement.
      ...{ full, trial, readme: readme && !trial, help, meshes: positionals },
      sizes: sizesOf(values.sizes ?? (full ? '2500,10000,30000,100000' : '2500,10000')),
      names: listOf('problems', values.problems, letters),
      parts: values.parts ? listOf('parts', values.parts, all) : chosen,
      where: listOf('where', values.where, ['native', 'browser']),
    };
  } catch (error) {
    throw error instanceof Problem ? error : new Problem(`${error.message}\n\n${usage}`);
  }
}

/**
 * Builds what is measured. Returns the browser's version, `on`, which measures a problem in a place
 * if the options name that place, and `close`.
 */
async function begin({ where, trial }) {
  const isWanted = (place) => where.includes(place);
  if (isWanted('browser') && !trial) {
    await setUp({ checks: true });
    await buildSite();
  }
  const browser = isWanted('browser') ? await startBrowser() : null;
  const native = isWanted('native') ? nativePlace(await nativeProgram(trial)) : null;
  const places = { browser: browser?.perform, native };
  const on = async (place, measure, problem, task = {}) => {
    const values = await places[place]?.(measure, { problem, ...task });
    return values && { vertices: problem.vertices, ...values };
  };
  return { version: browser?.version, on, close: () => browser?.close() };
}

/** Measures all cases of a part; a failure leaves the other rows, which took long. */
async function rowsOf(name, context) {
  const rows = [];
  for (const one of parts[name].cases(context)) {
    const words = Object.values(one).filter((value) => typeof value !== 'object');
    say([name, ...words].join(', '));
    try {
      const found = [await parts[name].measure(one, context)].flat();
      rows.push(...found.map((values) => ({ ...one, ...values })));
    } catch (error) {
      say(`failed: ${error.message}`);
      rows.push({ ...one, failed: error.message });
    }
  }
  return rows;
}

async function measure(options, words) {
  const { version, on, close } = await begin(options);
  const moment = options.trial ? 50 : 1000;
  const before = await unrest(moment);
  const rows = {};
  // Numbers of a busy machine are of use, but not in the README.
  const names = options.readme && !isQuiet(before) ? [] : options.parts;
  for (const name of names) rows[name] = await rowsOf(name, { ...options, on });
  await close();
  const machine = {
    command: ['npm run bench', ...(words.length ? ['--', ...words] : [])].join(' '),
    commit: outputOf('git', ['rev-parse', '--short', 'HEAD']),
    date: new Date().toISOString().slice(0, 10),
    processor: `one of the ${cpus().length} cores of an ${cpus()[0].model}`,
    versions: [version && `Chromium ${version}`, outputOf('rustc', ['--version'])],
    ...{ before, after: await unrest(moment) },
  };
  return { machine, rows };
}

function machineText({ command, commit, date, processor, versions, before, after }) {
  const on = [processor, ...versions].filter(Boolean).join(', ');
  return `\`${command}\` at ${commit} on ${date}, on ${on}. ${unrestText(before, after)}`;
}

/** Returns the tables of results as text: those of the README, or all. */
export function markdown({ machine, rows }, { readme = false } = {}) {
  const texts = Object.entries(rows).flatMap(([name, all]) =>
    parts[name].tables
      .filter((one) => one.readme || !readme)
      .map((one) => [one.title, table(one, all)])
      .filter(([, text]) => text),
  );
  return [machineText(machine), ...texts.flat()].join('\n\n');
}

/** The lines of the README that enclose its tables. */
export const marks = [
  '<!-- speed: written by `npm run bench -- --full --readme` -->\n',
  '<!-- end of speed -->\n',
];

function writeReadme(results) {
  const path = at('README.md');
  const [start, end] = marks;
  const [before, rest] = readFileSync(path, 'utf8').split(start);
  const after = rest?.split(end)[1];
  if (after === undefined) throw new Problem('README.md: the marks of the speed tables are gone');
  const section = markdown(results, { readme: true });
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
  const { before, after } = results.machine;
  if (!options.readme) return;
  if (![before, after].every(isQuiet)) throw new Problem('Not quiet: the README is not written.');
  writeReadme(results);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(() => bench(process.argv.slice(2)));
}
