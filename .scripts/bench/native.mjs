// The native half: builds the program of tests/bench/problems.rs and gives it tasks.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { outputOf, Problem, run, say } from '../run.mjs';
import { benchFolder } from './problems.mjs';

/** Builds the program and gives a function that performs a task. `profile`: Cargo's. */
export async function nativeSolver(profile) {
  say(`compiling the native benchmark (profile ${profile})`);
  const build = ['bench', '--locked', '--bench', 'problems', '--profile', profile, '--no-run'];
  await run('cargo', [...build, '--quiet']);
  const messages = outputOf('cargo', [...build, '--message-format', 'json']) ?? '';
  const program = messages
    .split('\n')
    .filter((line) => line.startsWith('{'))
    .map((line) => JSON.parse(line))
    .find(({ target, executable }) => target?.name === 'problems' && executable)?.executable;
  if (!program) throw new Problem('cargo does not say where the native benchmark is');
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
