// The results as tables in Markdown.

import { megabytes, missing, number, table } from './cells.mjs';
import { exactPeerTable, exactTable, variationTable } from './exact/tables.mjs';
import { nearness } from './measure.mjs';
import { problems } from './problems.mjs';
import { growth } from './statistics.mjs';
import { targetRows } from './targets.mjs';

const plural = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;

const ranged = ({ median, p10, p90 }) => `${number(median)} (${number(p10)}–${number(p90)})`;

/** Name of an accelerator in a table, from its name in scene files. */
export const accelerated = (word) => (word === 'none' ? 'plain' : (word ?? missing));

/** One row per problem, size, place and accelerator: milliseconds. */
export function iterationTable(rows) {
  const head = ['problem', 'vertices', 'where', 'accelerator', 'ms per iteration (10–90 %)'];
  head.push('projections', 'closeness', 'smoothness, handles', 'global step', 'the rest');
  head.push('limit', 'run in the page');
  return table(
    head,
    rows.map((row) => {
      const { step } = row;
      const parts = ['shape', 'close', 'smooth', 'global'].map((key) => step[key].median);
      const rest = Math.max(0, step.total.median - parts.reduce((sum, part) => sum + part, 0));
      return [
        row.problem,
        number(row.vertices),
        row.where,
        accelerated(row.accelerator),
        ranged(step.total),
        ...[...parts, rest, row.limit, row.run].map(number),
      ];
    }),
  );
}

/** Browser and native program: medians and minima of an iteration, and their ratios. */
export function ratioTable(rows) {
  const pairs = rows.flatMap((native) => {
    const same = (row) =>
      row.where === 'browser' &&
      ['problem', 'vertices', 'accelerator'].every((key) => row[key] === native[key]);
    const browser = native.where === 'native' && rows.find(same);
    return browser ? [{ native, browser }] : [];
  });
  const head = ['problem', 'vertices', 'accelerator', 'native', 'browser', 'ratio'];
  head.push('least, native', 'least, browser', 'ratio');
  return table(
    head,
    pairs.map(({ native, browser }) => {
      const of = (key) => [native.step.total[key], browser.step.total[key]];
      const withRatio = ([a, b]) => [a, b, b / a];
      const cells = [...withRatio(of('median')), ...withRatio(of('least'))];
      const key = [native.problem, number(native.vertices), accelerated(native.accelerator)];
      return [...key, ...cells.map(number)];
    }),
  );
}

/** Opening and editing with the default accelerator: milliseconds. */
export function setUpTable(rows) {
  const head = [
    'problem',
    'vertices',
    'where',
    'open',
    'of that load',
    'assemble',
    'order',
    'factor',
  ];
  head.push('to the first iteration', 'constraints changed', 'handle added', 'handle moved');
  head.push('nonzeros of L', 'MB of wasm');
  const chosen = rows.filter(({ accelerator }) => accelerator === 'quasi-newton');
  return table(
    head,
    chosen.map((row) => {
      const { total, assemble, order, factor, first } = row.setUp;
      const times = [total, total - assemble - order - factor, assemble, order, factor, first];
      const edits = [row.change, row.handle, row.drag.total.median];
      const cells = [...times, ...edits, row.nonzeros].map(number);
      const bytes = megabytes(row.bytes?.opened);
      return [row.problem, number(row.vertices), row.where, ...cells, bytes];
    }),
  );
}

/** The linear solve alone, in a first iteration without history, against the limit. */
export function solveTable(rows) {
  const head = [
    'problem',
    'vertices',
    'where',
    'precision',
    'one solve',
    'factor read twice',
    'ratio',
  ];
  return table(
    head,
    rows.map((row) => {
      const solve = row.fresh.global.median;
      const precision = `f${8 * row.bytesOfNumber}`;
      const cells = [solve, row.limit, row.limit === null ? null : solve / row.limit];
      return [row.problem, number(row.vertices), row.where, precision, ...cells.map(number)];
    }),
  );
}

export function convergenceTable(rows) {
  const head = ['problem', 'vertices', 'where', 'accelerator'];
  for (const part of nearness) head.push(`iterations to ${part}`, 'seconds');
  head.push('least, above the converged energy');
  return table(
    head,
    rows.map((row) => {
      const cells = row.reached.flatMap((one) =>
        one === null
          ? [`> ${number(row.iterations)}`, `> ${number(row.ms / 1e3)}`]
          : [number(one.iterations), number(one.ms / 1e3)],
      );
      const above = (row.least - row.converged) / row.converged;
      const nearest = above < nearness.at(-1) * 1.5 ? missing : above.toExponential(1);
      const about = row.certain ? '' : ' (the converged energy is not certain)';
      const key = [row.problem, number(row.vertices), row.where, accelerated(row.accelerator)];
      return [...key, ...cells, nearest + about];
    }),
  );
}

/** The accelerator that first comes within 1e-4, for every problem, size and place. */
export function firstToConverge(rows) {
  const keyOf = (row) => `${row.problem}, ${number(row.vertices)} vertices, ${row.where}`;
  const second = (row) => row.reached[1]?.ms ?? Infinity;
  const lines = [...new Set(rows.map(keyOf))].map((key) => {
    const same = rows.filter((row) => keyOf(row) === key);
    const [first] = same.toSorted((a, b) => second(a) - second(b));
    const name = second(first) < Infinity ? accelerated(first.accelerator) : 'none of them in time';
    return `- ${key}: ${name}`;
  });
  return `First to ${nearness[1]}:\n\n${lines.join('\n')}`;
}

const mapTable = (rows) =>
  table(
    ['problem', 'vertices', 'where', 'first', 'ms', 'assemble', 'order', 'factor', 'iterate', 'MB'],
    rows.map((row) => {
      const times = [row.cold, row.total, row.assemble, row.order, row.factor, row.iterate];
      const key = [row.problem, number(row.vertices), row.where];
      return [...key, ...times.map(number), megabytes(row.bytes)];
    }),
  );

/** Both numeric factors: from changed constraints to the first iteration, and the factor alone. */
export function factorTable(rows) {
  const head = ['problem', 'vertices', 'unknowns', 'nonzeros of L'];
  head.push('changed, sprs-ldl', 'changed, supernodal', 'factor, sprs-ldl', 'factor, supernodal');
  return table(
    head,
    rows.map(({ problem, vertices, unknowns, nonzeros, of }) => {
      const both = ['sprs-ldl', 'supernodal'].map((name) => of[name]);
      const changed = both.map(({ change }) => ranged(change));
      const factors = both.map(({ factor }) => number(factor.median));
      return [problem, ...[vertices, unknowns, nonzeros].map(number), ...changed, ...factors];
    }),
  );
}

/** Fabrication, from a shape to files. */
export function partsTable(rows) {
  const head = ['panels', 'where', 'build', 'fins', 'paper', 'axes of three kinds'];
  head.push('another distance', 'pictures of all sheets', 'all files');
  return table(
    head,
    rows.map(({ panels, where, build, fins, paper, axes, distance, sheets, files }) => [
      ...[number(panels), where],
      ...[build, fins, paper, axes, distance, sheets, files].map(number),
    ]),
  );
}

/** A frame with and without shading. */
export function lookTable(rows) {
  const head = ['of the look', 'triangles', 'ms per frame (10–90 %)', 'over nothing of it'];
  return table(
    head,
    rows.map((row) => [row.look, number(row.triangles), ranged(row), number(row.ratio)]),
  );
}

/** Milliseconds since the navigation began. */
export function startTable(start) {
  const names = { cold: 'first visit', warm: 'second visit', again: 'third visit' };
  const head = ['visit', 'first paint', 'model there, solved', 'first frame drawn', 'kB'];
  return table(
    head,
    Object.entries(names).map(([key, name]) => {
      const { painted, solved, drawn, bytes } = start[key];
      const times = [painted, solved, drawn].map((ms) => number(ms && Math.round(ms)));
      return [name, ...times, number(Math.round(bytes / 1e3))];
    }),
  );
}

export function peerTable(rows) {
  const head = ['peer', 'what', 'vertices', 'its ms', 'ours natively, plain', 'default'];
  head.push('ours in the browser, plain', 'default', 'its over ours (browser, plain)');
  return table(
    head,
    rows.map(({ peer, version, what, size, theirs, ours }) => {
      const of = (where, accelerator) =>
        ours.find((one) => one.where === where && (one.accelerator ?? accelerator) === accelerator)
          ?.ms;
      const cells = ['native', 'browser'].flatMap((where) =>
        ['none', 'quasi-newton'].map((accelerator) => number(of(where, accelerator))),
      );
      const its = theirs.ms === undefined ? (theirs.reason ?? missing) : number(theirs.ms);
      const ratio = theirs.ms / of('browser', 'none');
      const name = version ? `${peer} ${version}` : peer;
      return [name, what, number(size), its, ...cells, number(ratio)];
    }),
  );
}

function growthTable(rows) {
  const head = ['problem', 'where', 'accelerator', 'vertices', 'exponent', 'over n log n'];
  const keys = [...new Set(rows.map((row) => `${row.problem},${row.where},${row.accelerator}`))];
  const cells = keys.map((key) => {
    const [problem, where, accelerator] = key.split(',');
    const same = rows.filter(
      (row) => row.problem === problem && row.where === where && row.accelerator === accelerator,
    );
    const ends = [same[0], same.at(-1)].map((row) => [row.vertices, row.step.total.median]);
    const { exponent, overLinearithmic } = growth(...ends);
    const sizes = ends.map(([vertices]) => number(vertices)).join(' to ');
    return [
      problem,
      where,
      accelerated(accelerator),
      sizes,
      ...[exponent, overLinearithmic].map(number),
    ];
  });
  return table(head, cells);
}

/** Describes the machine and the run in a sentence or two. */
export function machineText({ command, date, processor, cores, browser, rustc, commit, load }) {
  const where = [browser && `Chromium ${browser}`, rustc].filter(Boolean).join(', ');
  const busy = load > 0.5 ? ` It was not quiet: ${number(load)} programs were running before.` : '';
  return `\`${command}\` at ${commit} on ${date}, on one of the ${plural(cores, 'core')} of an ${processor}, ${where}.${busy}`;
}

/** Returns all results. */
export function markdown(results) {
  const { iterations, factors, maps, convergence, models, start, operators, peers } = results;
  const { parts, exact, exactPeers, look } = results;
  const sections = [`# How fast it is\n\n${machineText(results.machine)} Milliseconds, medians.`];
  const add = (title, ...texts) => sections.push(`## ${title}\n\n${texts.join('\n\n')}`);
  const titles = Object.entries(problems).filter(([, problem]) => !problem.for);
  add('Problems', titles.map(([letter, { title }]) => `- ${letter}: ${title}`).join('\n'));
  if (iterations?.length) {
    const note =
      'The limit is the time to read the nonzeros of the factor twice (4 bytes each; 8 in the plain iteration of a small factor). "Run in the page" is the site\'s own worker, with all that it does beside iterating.';
    add('An iteration', iterationTable(iterations), note);
    const both = ['native', 'browser'].every((place) =>
      iterations.some((row) => row.where === place),
    );
    if (both) add('The browser beside the native program', ratioTable(iterations));
    add('One solve against the limit', solveTable(iterations));
    add('Setting up and editing', setUpTable(iterations));
    if (results.sizes.length > 1) add('Growth', growthTable(iterations));
  }
  if (factors?.length) {
    const note =
      'From changed constraints to the end of the first iteration (10–90 %), in the browser.';
    add('Both numeric factors', factorTable(factors), note);
  }
  if (maps?.length) add('Conformal maps', mapTable(maps));
  if (convergence) {
    add('To the converged energy', convergenceTable(convergence), firstToConverge(convergence));
  }
  if (models) {
    const [first, last] = [models.opened[0], models.opened.at(-1)].map(megabytes);
    const text = `${models.opened.length} models of problem A with ${number(models.vertices)} vertices, one after the other: ${megabytes(models.empty)} MB before, ${first} MB with the first, ${last} MB with the last.`;
    add('Memory', text);
  }
  if (parts?.length) add('Parts and sheets', partsTable(parts));
  if (exact?.length) {
    const note =
      'Distances are the greatest of a corner to its circle or plane, as parts of the size of the mesh; seconds are those from the soft solution, which is what "soft s" was for. Memory is that of the whole module.';
    add('Hard constraints', exactTable(exact), note);
    const variations = 'Milliseconds; each step is a fiftieth of the size along one mode.';
    add('Variations', variationTable(exact), variations);
  }
  if (exactPeers?.length) {
    const note =
      'Other libraries, natively, from the mesh as it is; of compas_shapeop the weights that come nearest, of several. Ours from the soft solution, and edges keep three tenths of their length.';
    add('Hard constraints and other libraries', exactPeerTable(exactPeers, exact), note);
  }
  if (start) add('Opening the page', startTable(start));
  if (look?.length) {
    const note =
      'Frames of a turning model at 1440x900, one of each in turn, drawn by software; the ratio is the median of those to the frame beside it.';
    add('The look', lookTable(look), note);
  }
  if (peers) {
    const notes = new Map(peers.map(({ what, equal, differs }) => [what, [equal, differs]]));
    const lines = [...notes].map(
      ([what, [equal, differs]]) => `- ${what}. Equal: ${equal}. Different: ${differs}.`,
    );
    add('Peers', peerTable(peers), lines.join('\n'));
  }
  if (operators?.native) add('Operators alone, natively', operators.native);
  if (operators?.browser) add('Operators alone, in the browser', operators.browser.trim());
  const targets = targetRows(results);
  if (targets.length) {
    const rows = targets.map(({ name, target, found, met }) => [
      name,
      target,
      number(found),
      met ? 'met' : '**missed**',
    ]);
    add('Targets', table(['in the browser', 'target', 'found', ''], rows));
  }
  return `${sections.join('\n\n')}\n`;
}
