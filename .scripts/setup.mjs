// Installs what a new machine with Rust and Node lacks. Checks first: a second run takes well under
// a second.

import { setUpBrowser } from './setup-browser.mjs';
import { setUpPackages } from './setup-packages.mjs';
import { setUpRust } from './setup-rust.mjs';
import { Problem } from './run.mjs';

const oldestNode = [20, 19];

/** Installs what building needs; with `checks` also what tests need, some of them a `browser`. */
export async function setUp({ checks, browser = checks }) {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major < oldestNode[0] || (major === oldestNode[0] && minor < oldestNode[1])) {
    throw new Problem(
      `Node ${oldestNode.join('.')} or newer is needed, this is ${process.version}`,
    );
  }
  await setUpRust({ checks });
  await setUpPackages();
  if (browser) await setUpBrowser();
}
