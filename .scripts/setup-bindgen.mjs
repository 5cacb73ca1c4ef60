// The wasm-bindgen command line and its test runner, in .tools/, at exactly the version of the
// crate in Cargo.lock: any other version rejects the compiled module.

import { basename } from 'node:path';
import { at, lockedVersion } from './project.mjs';
import { outputOf, Problem, run, say } from './run.mjs';

/** The program that writes the JavaScript side of a compiled module. */
export const wasmBindgen = at('.tools', 'bin', 'wasm-bindgen');

/** The program that serves the tests of a compiled module. */
export const testRunner = at('.tools', 'bin', 'wasm-bindgen-test-runner');

/** Installs both if they are missing or of another version. */
export async function setUpBindgen() {
  const version = lockedVersion('wasm-bindgen');
  const current = [wasmBindgen, testRunner].map((program) => outputOf(program, ['--version']));
  if (current.every((line) => line?.split(' ')[1] === version)) return;

  say(`building wasm-bindgen ${version} into .tools/ (once, some minutes)`);
  const programs = [wasmBindgen, testRunner].flatMap((program) => ['--bin', basename(program)]);
  const args = [
    ...['install', 'wasm-bindgen-cli', '--version', `=${version}`, '--root', at('.tools')],
    ...[...programs, '--force'],
  ];
  // Each runs for a second: optimising them fully takes a minute more than it saves.
  const env = { CARGO_PROFILE_RELEASE_OPT_LEVEL: '1' };
  try {
    await run('cargo', [...args, '--locked'], { env });
  } catch {
    // A registry mirror can lag behind the versions in the tool's own lock file.
    say('its lock file does not work here: building with the newest matching versions');
    await run('cargo', args, { env });
  }
  if (outputOf(wasmBindgen, ['--version']) === null) {
    throw new Problem(`${wasmBindgen}: was installed, but does not run`);
  }
}
