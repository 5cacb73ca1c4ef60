// Debian and Ubuntu packages, installed only with sufficient rights.

import { outputOf, run } from './run.mjs';

/** Whether packages can be installed without asking the user: root, with apt. */
export const canInstall = () =>
  process.getuid?.() === 0 && outputOf('apt-get', ['--version']) !== null;

/** Installs packages. Rejects with a `Problem` if apt fails. */
export async function install(...packages) {
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  await run('apt-get', ['update', '-qq'], { env });
  await run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...packages], { env });
}
