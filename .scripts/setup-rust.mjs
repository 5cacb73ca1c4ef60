// Rust: a linker, the wasm target, the formatter and the lints.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import * as apt from './apt.mjs';
import { wasmTarget } from './project.mjs';
import { outputOf, Problem, run, say } from './run.mjs';

/** Ensures that the toolchain is complete; with `checks` also what only `npm test` uses. */
export async function setUpRust({ checks }) {
  const sysroot = outputOf('rustc', ['--print', 'sysroot']);
  if (sysroot === null || outputOf('cargo', ['--version']) === null) {
    throw new Problem('Rust is missing. Install it with rustup: https://rustup.rs');
  }
  await setUpLinker();
  if (!existsSync(join(sysroot, 'lib', 'rustlib', wasmTarget))) {
    await rustup(['target', 'add', wasmTarget]);
  }
  if (checks) {
    const missing = [
      ['rustfmt', 'cargo-fmt'],
      ['clippy', 'cargo-clippy'],
    ].filter(([, program]) => !existsSync(join(sysroot, 'bin', program)));
    if (missing.length) await rustup(['component', 'add', ...missing.map(([name]) => name)]);
  }
}

async function rustup(args) {
  say(`rustup ${args.join(' ')}`);
  if (outputOf('rustup', ['--version']) === null) {
    throw new Problem(`rustup is missing, so Rust lacks: ${args.join(' ')}. See https://rustup.rs`);
  }
  await run('rustup', args);
}

// Cargo links native programs, including build scripts, with the system's C compiler.
async function setUpLinker() {
  if (outputOf('cc', ['--version']) !== null) return;
  if (!apt.canInstall()) {
    throw new Problem(
      'A C compiler is missing, Rust links with it: sudo apt install build-essential',
    );
  }
  say('installing the system package build-essential: Rust links with its C compiler');
  await apt.install('build-essential');
}
