// The npm packages of package-lock.json.

import { statSync } from 'node:fs';
import { at } from './project.mjs';
import { run, say } from './run.mjs';

const changed = (path) => statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? 0;

/** Installs them if node_modules is missing or older than the lock file. */
export async function setUpPackages() {
  // npm writes this file last.
  const installed = changed(at('node_modules', '.package-lock.json'));
  if (installed > 0 && installed >= changed(at('package-lock.json'))) return;
  say('installing the npm packages of the lock file');
  await run('npm', ['ci', '--no-audit', '--no-fund']);
}
