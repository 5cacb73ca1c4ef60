// Measures problems natively: with the command-line program.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { program, targetFolder } from '../project.mjs';
import { outputOf, Problem, run, say } from '../run.mjs';
import { benchFolder } from './problems.mjs';
import { median } from './statistics.mjs';

/** The iterations of a short run, and how often it and a longer one are made. */
const FEW = 20;
const TIMES = 5;

const reportFile = join(benchFolder, 'report.json');

/** Compiles the program; a trial takes the one that `cargo test` leaves. */
export async function nativeProgram(trial) {
  if (trial && !existsSync(program)) throw new Problem('cargo test builds what a trial measures');
  if (trial) return program;
  say('compiling the native program');
  await run('cargo', ['build', '--locked', '--quiet', '--release', '--bin', 'shape-up']);
  return join(targetFolder, 'release', 'shape-up');
}

/** Returns a function that performs a measurement, under the same name as in `measures.mjs`. */
export function nativePlace(program) {
  const call = (...words) => {
    const started = performance.now();
    if (outputOf(program, words) === null) throw new Problem(`${program} ${words.join(' ')} fails`);
    return performance.now() - started;
  };
  const reportOn = (...words) => {
    call(...words, '--report', reportFile);
    return JSON.parse(readFileSync(reportFile, 'utf8'));
  };
  const measures = {
    /**
     * Everything that an iteration does, the recording of its energies included: the difference of
     * runs of two lengths, of half a second or more unless `least` is zero.
     */
    iterations({ problem, least }) {
      const traced = problem.traced ? ['--trace'] : [];
      const take = (count) => call('solve', problem.sceneFile, '--iterations', count, ...traced);
      const more = Math.max(100, least && Math.round(1.5e6 / problem.vertices));
      const pairs = Array.from({ length: least ? TIMES : 1 }, () => [take(FEW), take(FEW + more)]);
      const [few, many] = [0, 1].map((k) => median(pairs.map((pair) => pair[k])));
      return { total: (many - few) / more };
    },
    exact({ problem }) {
      const { exact } = reportOn('solve', problem.sceneFile);
      const { seconds, max_distance, misses } = exact;
      return { seconds, distance: max_distance / problem.size, misses };
    },
    map({ problem }) {
      const report = reportOn('parametrize', problem.meshFile, '--weights', problem.map);
      return { cold: 1e3 * report.seconds.total, eigenvalue: report.eigenvalue };
    },
  };
  return (measure, task) => measures[measure](task);
}
