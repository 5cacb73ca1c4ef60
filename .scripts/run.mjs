// Running other programs, and ending with a message when something is wrong.

import { spawn, spawnSync } from 'node:child_process';
import { root } from './project.mjs';

/** Something the user can act on: printed as it is, without a stack. */
export class Problem extends Error {}

/** Says what is being done, on a line of its own. */
export const say = (text) => console.log(`- ${text}`);

/** Runs a program with its output on the terminal. Rejects with a `Problem` when it fails. */
export function run(command, args, { env = {} } = {}) {
  return new Promise((done, reject) => {
    const child = spawn(command, args, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ['ignore', 'inherit', 'inherit'],
    });
    child.on('error', (error) => reject(new Problem(`${command}: ${error.message}`)));
    child.on('close', (code, signal) => {
      if (code === 0) done();
      else reject(new Problem(`${command} ${args.join(' ')}: ended with ${signal ?? code}`));
    });
  });
}

/** What a program prints, or null where it is missing or fails. */
export function outputOf(command, args) {
  const { status, stdout } = spawnSync(command, args, {
    ...{ cwd: root, encoding: 'utf8' },
    // Cargo tells a lot.
    maxBuffer: 2 ** 27,
  });
  return status === 0 ? stdout.trim() : null;
}

/** Runs the body of a script: a `Problem` ends it with its message, anything else with a stack. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Problem ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}
