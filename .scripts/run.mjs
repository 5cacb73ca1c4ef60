// Runs other programs, and ends with a message on errors.

import { spawn, spawnSync } from 'node:child_process';
import { root } from './project.mjs';

/** An error the user can act on: printed without a stack. */
export class Problem extends Error {}

/** Prints the current activity, on a line of its own. */
export const say = (text) => console.log(`- ${text}`);

/** Runs a program with its output on the terminal. Rejects with a `Problem` if it fails. */
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

/** Returns the output of a program; null if it is missing or fails. */
export function outputOf(command, args) {
  const { status, stdout } = spawnSync(command, args, {
    ...{ cwd: root, encoding: 'utf8' },
    // The output of Cargo can be large.
    maxBuffer: 2 ** 27,
  });
  return status === 0 ? stdout.trim() : null;
}

/** Runs the body of a script: prints the message of a `Problem`, the stack of any other error. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Problem ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}
