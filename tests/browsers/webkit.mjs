// WebKit: the MiniBrowser of WebKitGTK, driven by WebDriver (https://w3c.github.io/webdriver), which
// WebKitWebDriver speaks.

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { freePort } from '../../.scripts/serve.mjs';
import { actionsOf } from './pointer.mjs';
import { begin, pathOf } from './programs.mjs';

/** The key of an element in answers, fixed by the standard. */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';
const STARTS_WITHIN_MS = 10_000;

export const webkit = {
  name: 'WebKit',
  path: () => (pathOf('WebKitWebDriver') && miniBrowser()) ?? null,

  /** @returns {Promise<import('./story.mjs').Browser>} */
  async start(path, env) {
    const send = await beginDriver(env);
    const options = { binary: path, args: ['--automation'] };
    const { sessionId } = await send('POST', '/session', {
      capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': options } },
    });
    const command = (name, body) => send('POST', `/session/${sessionId}/${name}`, body);
    await command('window/rect', { x: 0, y: 0, width: 1440, height: 900 });
    await command('timeouts', { script: 120_000 });

    return {
      open: (url) => command('url', { url }),
      async ask(text, ...args) {
        const script = `const given = [...arguments], done = given.pop();
          Promise.resolve((${text})(...given)).then((value) => done({ value }),
            (error) => done({ error: String(error) }));`;
        const { value, error } = await command('execute/async', { script, args });
        if (error) throw new Error(error);
        return value;
      },
      async choose(selector, file) {
        const found = await command('element', { using: 'css selector', value: selector });
        await command(`element/${found[ELEMENT]}/value`, { text: file });
      },
      pointer: (way, keys) => command('actions', { actions: actionsOf(way, keys) }),
    };
  },
};

/** Returns the path of the MiniBrowser, which is not among the commands; nothing if it is not there. */
const miniBrowser = () =>
  readdirSync('/usr/lib')
    .flatMap((machine) => ['4.0', '4.1'].map((api) => join(machine, `webkit2gtk-${api}`)))
    .map((folder) => join('/usr/lib', folder, 'MiniBrowser'))
    .findLast(existsSync);

/** Starts the driver; returns a function that sends it a command and resolves with its value. */
async function beginDriver(env) {
  const port = await freePort();
  const driver = `http://127.0.0.1:${port}`;
  begin('WebKitWebDriver', [`--port=${port}`], { env, stdio: 'ignore' });
  const start = performance.now();
  while (!(await fetch(`${driver}/status`).catch(() => null))?.ok) {
    if (performance.now() > start + STARTS_WITHIN_MS) throw new Error(`${driver} does not answer`);
    await wait(100);
  }
  return async (method, path, body) => {
    const answer = await fetch(driver + path, { method, body: body && JSON.stringify(body) });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${path}: ${value.error}: ${value.message}`);
    return value;
  };
}
