// The archive of the sources has the files of the repository, and nothing else that lies beside them.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { ownSources } from '../../.scripts/sources.mjs';

test('what no commit has is not published', () => {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-sources-'));
  try {
    for (const name of ['src', 'dist']) mkdirSync(join(folder, name));
    writeFileSync(join(folder, '.gitignore'), '/dist\n');
    for (const name of ['src/lib.rs', 'dist/index.html', 'notes.txt'])
      writeFileSync(join(folder, name), '');
    // As unpacked from the archive.
    const entries = ['.gitignore', 'notes.txt', 'src'];
    assert.deepEqual(ownSources(folder), { entries, built: ['dist'] });
    for (const words of [
      ['init', '--quiet'],
      ['add', '.gitignore', 'src/lib.rs'],
    ])
      execFileSync('git', ['-C', folder, ...words]);
    assert.deepEqual(ownSources(folder), { entries: ['.gitignore', 'src/lib.rs'], built: [] });
    // Everything was published when git failed, as it does in a folder of another user.
    writeFileSync(join(folder, '.git/index'), 'damaged');
    assert.throws(() => ownSources(folder), /git cannot list the files/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
