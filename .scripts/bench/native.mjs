// Measures problems natively: with the command-line program.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { program, targetFolder } from '../project.mjs';
import { outputOf, Problem, run, say } from '../run.mjs';
import { benchFolder } from './problems.mjs';
import { spread } from './statistics.mjs';

/** The iterations of a short run, and how often it and a longer one are made. */
const FEW = 20;
const TIMES = 5;

const reportFile = join(benchFolder, 'report.json');

/** Compiles the program; a trial takes the one that `cargo test` leaves. */
async function compiled(trial) {
  if (trial && !existsSync(program)) throw new Problem('cargo test builds what a trial measures');
  if (trial) return program;
  say('compiling the native program');
  await run('cargo', ['build', '--locked', '--quiet', '--release', '--bin', 'shape-up']);
  return join(targetFolder, 'release', 'shape-up');
}

/** Returns { perform }, which performs a measurement: the same names as in `measures.mjs`. */
export async function startNative(trial) {
  const program = await compiled(trial);
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
     * runs of two lengths, of half a second or more unless it is a trial.
     */
    iterations({ sceneFile, traced, vertices }) {
      const more = trial ? 100 : Math.max(100, Math.round(1.5e6 / vertices));
      const words = ['solve', sceneFile, ...(traced ? ['--trace'] : []), '--iterations'];
      const of = (accelerator) => {
        const take = (count) => call(...words, count, '--accelerator', accelerator);
        const pair = () => take(FEW + more) - take(FEW);
        return { total: spread(Array.from({ length: TIMES }, () => pair() / more)) };
      };
      return { none: of('none'), 'quasi-newton': of('quasi-newton') };
    },
    /** How many numbers the factor has. */
    nonzeros: ({ sceneFile }) => reportOn('solve', sceneFile, '--iterations', '1').factor_nonzeros,
    exact({ sceneFile, size }) {
      const { seconds, max_distance, misses } = reportOn('solve', sceneFile).exact;
      return { seconds, distance: max_distance / size, misses };
    },
    maps({ meshFile, map }) {
      const { seconds, eigenvalue } = reportOn('parametrize', meshFile, '--weights', map);
      return { cold: 1e3 * seconds.total, eigenvalue };
    },
    /** Panels along the lines of curvature of a mesh: the seconds. */
    remesh({ from, to, panels, boundary }) {
      const wishes = ['--quads', String(panels), '--boundary', boundary];
      const { seconds } = reportOn('remesh', from, ...wishes, '--out', to);
      return { seconds: seconds.total };
    },
    /** How quads lie, and what becomes of them when they are made circular. */
    circular({ meshFile }) {
      const { faces, curvature } = reportOn('check', meshFile);
      const press = ['solve', meshFile, '--panels', 'circle', '--within', 'auto'];
      const { moved, folded, level } = reportOn(...press).verdict;
      return { made: faces, degrees: curvature.mean_degrees, moved, folded, level };
    },
    /** How far corners are from their circle or plane in a mesh of another library. */
    distance({ meshFile, kind, size }) {
      const { circularity, planarity } = reportOn('check', meshFile);
      return (kind === 'circle' ? circularity : planarity).max_distance / size;
    },
  };
  return { perform: (measure, problem) => measures[measure](problem) };
}
