// npm run bench, second part: nanoseconds per constraint of every operator, natively and in
// headless Chromium.

import { join } from 'node:path';
import { browserFlags, findBrowser } from './browser.mjs';
import { targetFolder, wasmTarget } from './project.mjs';
import { main, run } from './run.mjs';
import { serve } from './serve.mjs';
import { setUp } from './setup.mjs';
import { wasmBindgen } from './setup-bindgen.mjs';

const name = 'operators_wasm';
const folder = join(targetFolder, 'bench');

await main(async () => {
  await setUp({ checks: true });
  console.log('\nNanoseconds per constraint, natively:\n');
  await run('cargo', ['bench', '--locked', '--quiet', '--bench', 'operators']);

  await run('cargo', [
    ...['build', '--locked', '--release', '--example', name],
    ...['--target', wasmTarget, '--no-default-features', '--features', 'solver'],
  ]);
  const compiled = join(targetFolder, wasmTarget, 'release', 'examples', `${name}.wasm`);
  await run(wasmBindgen, ['--target', 'web', '--out-dir', folder, compiled]);
  const { address, close } = await serve(folder, { port: 4401 });
  const { chromium } = await import('@playwright/test');
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: browserFlags,
  });
  const page = await browser.newPage();
  await page.route(address, (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>bench</title>' }),
  );
  await page.goto(address);
  const table = await page.evaluate(async (url) => {
    const module = await import(url);
    await module.default();
    return module.operators();
  }, `${address}${name}.js`);
  console.log(`\nIn the browser:\n\n${table}`);
  await browser.close();
  close();
});
