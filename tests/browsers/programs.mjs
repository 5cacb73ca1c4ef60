// What browsers need beside themselves: a screen, and folders for what they write.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { outputOf } from '../../.scripts/run.mjs';

/** Returns the path of the first of these programs that is there; null if none is. */
export const pathOf = (...names) =>
  names.map((name) => outputOf('which', [name])).find(Boolean) ?? null;

/** Makes a folder with these files, given as an object by name, that goes when this process ends. */
export function folderOfOwn(files) {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  process.once('exit', () => rmSync(folder, { recursive: true, force: true }));
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return folder;
}

/** The programs that have been started, and not ended. */
const running = new Set();

/** Starts a program, until `endAll`. */
export function begin(command, args, options) {
  const program = spawn(command, args, options);
  running.add(program);
  return program;
}

/** Ends all programs, and resolves when they have ended. */
export async function endAll() {
  for (const program of running) {
    program.kill();
    if (program.exitCode === null && program.signalCode === null) await once(program, 'exit');
  }
  running.clear();
}

/**
 * Starts a virtual screen: without one, Firefox has no WebGL, and the MiniBrowser does not start.
 * Resolves with the environment of what is shown there.
 */
export async function beginScreen() {
  const screen = begin('Xvfb', ['-displayfd', '1', '-screen', '0', '1600x1000x24'], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const [display] = await once(createInterface(screen.stdout), 'line');
  return { ...process.env, DISPLAY: `:${display}`, WAYLAND_DISPLAY: undefined };
}
