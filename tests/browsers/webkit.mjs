// WebKit: the MiniBrowser of WebKitGTK, driven by WebDriver (https://w3c.github.io/webdriver), which
// WebKitWebDriver speaks.

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { actionsOf } from './pointer.mjs';
import { begin, pathOf } from './programs.mjs';

/** The key of an element in answers, fixed by the standard. */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';
const DRIVER = 'http://127.0.0.1:4723';
const STARTS_WITHIN_MS = 10_000;

export const webkit = {
  name: 'WebKit',
  path: () => (pathOf('WebKitWebDriver') && miniBrowser()) ?? null,

  /** @returns {Promise<import('./story.mjs').Browser>} */
  async start(path, env) {
    begin('WebKitWebDriver', [`--port=${new URL(DRIVER).port}`], { env, stdio: 'ignore' });
    await answering();
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

/** Resolves when the driver answers. */
async function answering() {
  const start = performance.now();
  for (;;) {
    const status = await fetch(`${DRIVER}/status`).catch(() => null);
    if (status?.ok) return;
    if (performance.now() > start + STARTS_WITHIN_MS) throw new Error(`${DRIVER} does not answer`);
    await wait(100);
  }
}

/** Sends a command to the driver, and resolves with its value. */
async function send(method, path, body) {
  const answer = await fetch(DRIVER + path, { method, body: body && JSON.stringify(body) });
  const { value } = await answer.json();
  if (!answer.ok) throw new Error(`${path}: ${value.error}: ${value.message}`);
  return value;
}
