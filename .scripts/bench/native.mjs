// The native part: builds the program of tests/bench/problems.rs and passes it tasks.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { targetFolder } from '../project.mjs';
import { run, say } from '../run.mjs';
import { benchFolder } from './problems.mjs';

const name = 'bench_problems';

/** Builds the program and returns a function that performs a task. `profile`: dev or release. */
export async function nativeSolver(profile) {
  say(`compiling the native benchmark (${profile})`);
  // The features with which the tests have compiled it.
  const features = profile === 'dev' ? ['--features', 'view'] : [];
  const build = ['build', '--locked', '--quiet', '--example', name, '--profile', profile];
  await run('cargo', [...build, ...features]);
  const built = profile === 'dev' ? 'debug' : profile;
  const program = join(targetFolder, built, 'examples', name);
  const [taskFile, resultFile] = ['task.json', 'result.json'].map((name) =>
    join(benchFolder, name),
  );
  return async (task) => {
    const { problem, ...rest } = task;
    writeFileSync(taskFile, JSON.stringify({ ...rest, ...problem }));
    await run(program, [taskFile, resultFile]);
    return JSON.parse(readFileSync(resultFile, 'utf8'));
  };
}
