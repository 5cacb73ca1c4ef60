// Debian and Ubuntu packages, installed only where we may.

import { outputOf, run } from './run.mjs';

/** True where packages can be installed without asking anybody. */
export const canInstall = () =>
  process.getuid?.() === 0 && outputOf('apt-get', ['--version']) !== null;

/** Installs packages. Rejects with a `Problem` when apt does. */
export async function install(...packages) {
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  await run('apt-get', ['update', '-qq'], { env });
  await run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...packages], { env });
}
