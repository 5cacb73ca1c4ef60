// Firefox, driven by WebDriver BiDi (https://w3c.github.io/webdriver-bidi), which it speaks itself.

import { createInterface } from 'node:readline';
import { actionsOf } from './pointer.mjs';
import { begin, folderOfOwn, pathOf } from './programs.mjs';

/** Without questions at the start, and with WebGL on machines without a graphics card. */
const PREFERENCES = [
  ['browser.shell.checkDefaultBrowser', false],
  ['datareporting.policy.dataSubmissionEnabled', false],
  ['webgl.force-enabled', true],
];

export const firefox = {
  name: 'Firefox',
  path: () => pathOf('firefox-esr', 'firefox'),

  /** @returns {Promise<import('./story.mjs').Browser>} */
  async start(path, env) {
    const preferences = PREFERENCES.map(([key, value]) => `user_pref("${key}", ${value});`);
    const profile = folderOfOwn({ 'user.js': preferences.join('\n') });
    const args = ['--remote-debugging-port=0', '--profile', profile];
    const program = begin(path, args, { env, stdio: ['ignore', 'ignore', 'pipe'] });
    const send = await connect(`${await addressOf(program)}/session`);
    await send('session.new', { capabilities: {} });
    const { contexts } = await send('browsingContext.getTree', {});
    const { context } = contexts[0];
    const viewport = { width: 1440, height: 900 };
    await send('browsingContext.setViewport', { context, viewport });

    const called = async (text, args) => {
      const { type, result, exceptionDetails } = await send('script.callFunction', {
        functionDeclaration: text,
        arguments: args.map((value) => ({ type: typeof value, value })),
        target: { context },
        awaitPromise: true,
      });
      if (type === 'exception') throw new Error(exceptionDetails.text);
      return result;
    };
    return {
      open: (url) => send('browsingContext.navigate', { context, url, wait: 'complete' }),
      async ask(text, ...args) {
        const json = await called(
          `async (...given) => JSON.stringify(await (${text})(...given))`,
          args,
        );
        return json.value === undefined ? undefined : JSON.parse(json.value);
      },
      async choose(selector, file) {
        const { sharedId } = await called('(selector) => document.querySelector(selector)', [
          selector,
        ]);
        await send('input.setFiles', { context, element: { sharedId }, files: [file] });
      },
      pointer: (way, keys) =>
        send('input.performActions', { context, actions: actionsOf(way, keys) }),
    };
  },
};

/** Returns the address at which Firefox listens, which it prints. */
async function addressOf(program) {
  for await (const line of createInterface(program.stderr)) {
    const found = /WebDriver BiDi listening on (\S+)/.exec(line);
    if (found) {
      // Nobody reads on: what is printed must not fill the pipe.
      program.stderr.resume();
      return found[1];
    }
  }
  throw new Error('Firefox has ended');
}

/** Connects to a browser; returns a function that sends a command and resolves with its result. */
async function connect(address) {
  const socket = new WebSocket(address);
  await new Promise((done, reject) => {
    socket.onopen = done;
    socket.onerror = () => reject(new Error(`${address} does not answer`));
  });
  const waiting = new Map();
  socket.onmessage = ({ data }) => {
    const { id, type, result, message } = JSON.parse(data);
    const [done, reject] = waiting.get(id) ?? [];
    waiting.delete(id);
    if (type === 'success') done?.(result);
    else reject?.(new Error(message));
  };
  socket.onclose = () => waiting.forEach(([, reject]) => reject(new Error('Firefox has ended')));
  let count = 0;
  return (method, params) =>
    new Promise((done, reject) => {
      waiting.set(++count, [done, reject]);
      socket.send(JSON.stringify({ id: count, method, params }));
    });
}
