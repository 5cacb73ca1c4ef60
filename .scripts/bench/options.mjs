// The options of the command line.

import { parseArgs } from 'node:util';
import { Problem } from '../run.mjs';
import { problems } from './problems.mjs';

/** The parts of the benchmark, in the order of measurement. */
export const parts = [
  ...[
    'iterations',
    'factors',
    'convergence',
    'memory',
    'start',
    'build',
    'exact',
    'operators',
    'look',
    'peers',
  ],
];

/** Parts that are measured only if named, or with --full. */
const ASKED_FOR = ['factors', 'build', 'exact', 'operators', 'look', 'peers'];

export const usage = `npm run bench -- [options]

  --sizes N,N      vertices of the meshes (default 2500,10000; --full 2500,10000,30000,100000)
  --problems A,B   of A, B, C, D, E (default all but E: A with boundary curves and a trace)
  --parts P,P      of ${parts.join(', ')} (default all but ${ASKED_FOR.join(', ')})
  --where W,W      of native, browser (default both)
  --peers          the other libraries too, which pip puts under target/
  --full           all sizes and parts, and longer
  --limit SECONDS  for one run until it has converged (default 3; --full 20)
  --trial          check that it works: a quick build, no limits in the browser, other files
  --readme         write the tables of the README from what was measured
  --from FILE      make the tables from an earlier target/bench/bench.json, without measuring

Writes target/bench/bench.md and target/bench/bench.json.`;

const declared = {
  sizes: { type: 'string' },
  problems: { type: 'string' },
  parts: { type: 'string' },
  where: { type: 'string', default: 'native,browser' },
  peers: { type: 'boolean', default: false },
  full: { type: 'boolean', default: false },
  limit: { type: 'string' },
  trial: { type: 'boolean', default: false },
  readme: { type: 'boolean', default: false },
  from: { type: 'string' },
  help: { type: 'boolean', default: false },
};

function listOf(name, text, known) {
  const words = text.split(',').map((word) => word.trim());
  const strange = words.find((word) => !known.includes(word));
  if (strange !== undefined) {
    throw new Problem(`--${name} ${strange}: expected some of ${known.join(', ')}\n\n${usage}`);
  }
  return words;
}

function numberOf(name, text, least) {
  const value = Number(text);
  if (!(value >= least)) throw new Problem(`--${name} ${text}: expected a number from ${least} on`);
  return value;
}

/** Returns the options given by the arguments. */
export function optionsOf(words) {
  let values;
  try {
    ({ values } = parseArgs({ args: words, options: declared, strict: true }));
  } catch (error) {
    throw new Problem(`${error.message}\n\n${usage}`);
  }
  const { full } = values;
  const letters = Object.keys(problems).filter((letter) => !problems[letter].for);
  const unnamed = letters.filter((letter) => !problems[letter].named);
  const usual = parts.filter((part) => full || !ASKED_FOR.includes(part));
  const chosen = values.parts ? listOf('parts', values.parts, parts) : usual;
  const sizes = values.sizes ?? (full ? '2500,10000,30000,100000' : '2500,10000');
  return {
    sizes: sizes.split(',').map((size) => Math.round(numberOf('sizes', size, 36))),
    problems: values.problems ? listOf('problems', values.problems, letters) : unnamed,
    parts: new Set(values.peers ? [...chosen, 'peers'] : chosen),
    where: listOf('where', values.where, ['native', 'browser']),
    limitMs: 1e3 * numberOf('limit', values.limit ?? (full ? 20 : 3), 0.01),
    full,
    trial: values.trial,
    readme: values.readme,
    from: values.from ?? null,
    help: values.help,
  };
}
