// One step of `npm test`: runs a program and shows its output only if it fails.

import { spawn } from 'node:child_process';
import { root } from './project.mjs';

const secondsSince = (start) => ((performance.now() - start) / 1000).toFixed(1);

/** Runs a program and resolves with { ok, output }. Prints its progress every half a minute. */
export function step(title, command, args, env = {}) {
  const start = performance.now();
  console.log(`- ${title}`);
  return new Promise((done) => {
    const child = spawn(command, args, {
      cwd: root,
      env: { ...process.env, FORCE_COLOR: '0', CARGO_TERM_COLOR: 'never', ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    let output = '';
    const gather = (chunk) => (output += chunk);
    child.stdout.setEncoding('utf8').on('data', gather);
    child.stderr.setEncoding('utf8').on('data', gather);
    const pulse = setInterval(() => {
      const last = output.trimEnd().split('\n').at(-1).trim();
      console.log(`    ${title}, ${secondsSince(start)} s: ${last}`);
    }, 30_000);

    const end = (ok) => {
      clearInterval(pulse);
      if (!ok) console.log(output);
      console.log(`    ${title}: ${ok ? 'ok' : 'FAILED'} (${secondsSince(start)} s)`);
      done({ ok, output });
    };
    child.on('error', (error) => {
      output += `${command}: ${error.message}\n`;
      end(false);
    });
    child.on('close', (code) => end(code === 0));
  });
}
