// Content security policy: the page sends nothing to other sites and never runs text as a script.
// One test goes through a whole story without a violation. A proxy stands for the rest of the
// network and records every request to another site by the page, a worker or the browser.

import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { addConstraint, exported, openText, runToTheEnd, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { dragVertex, expect, openPage, test as base, waitForState } from '../support.ts';

declare global {
  interface Window {
    tellViolation(text: string): void;
    /** Set by a script that the policy forbids. */
    wasRun?: boolean;
  }
}

/** Addresses that were asked for. */
type Asked = (string | undefined)[];

const test = base.extend<{
  net: { asked: Asked; address: string };
  elsewhere: Asked;
  violations: string[];
}>({
  /** The proxy, and the requests that it receives. */
  // eslint-disable-next-line no-empty-pattern
  net: async ({}, use) => {
    const asked: Asked = [];
    const server = createServer((request, response) => {
      asked.push(request.url);
      response.writeHead(502).end();
    });
    server.on('connect', ({ url }, socket) => {
      asked.push(url);
      socket.destroy();
    });
    await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
    const { port } = server.address() as AddressInfo;
    await use({ asked, address: `http://127.0.0.1:${port}` });
    server.closeAllConnections();
    server.close();
  },
  proxy: async ({ net }, use) => use({ server: net.address, bypass: '127.0.0.1' }),
  elsewhere: async ({ net }, use) => use(net.asked),
  /** Violations of the policies of the page and its workers. */
  violations: async ({ page }, use) => {
    const found: string[] = [];
    await page.exposeFunction('tellViolation', (text: string) => found.push(text));
    await page.addInitScript(() =>
      window.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
        window.tellViolation(`${violatedDirective}: ${blockedURI}`),
      ),
    );
    page.on('worker', (worker) => {
      worker.on('console', (message) => {
        if (/Content Security Policy/.test(message.text())) found.push(message.text());
      });
    });
    await use(found);
  },
});

test.use({ fresh: true, serviceWorkers: 'allow' });

test('from opening to sharing there are no requests to other sites and no violations', async ({
  page,
  elsewhere,
  violations,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  await runToTheEnd(page);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Tab');
  await dragVertex(page, 12, [30, -20]);
  await waitForState(page, (now) => !now.running);
  expect((await exported(page, 'OBJ')).text).toContain('\nf ');
  // rhino3dm creates functions from text, and does so in a worker of its own.
  const rhino = await exported(page, '3DM');
  const given = { name: 'back.3dm', mimeType: 'application/octet-stream', buffer: rhino.bytes };
  await page.getByLabel('Open file').setInputFiles(given);
  await expect(page.getByRole('status')).toHaveText(/Opened back.*: 25 vertices/);
  await tool(page, 'Share');
  const link = page.getByRole('dialog', { name: 'Share' }).getByRole('textbox', { name: 'Link' });
  const address = await link.inputValue();
  await page.goto('about:blank');
  await page.goto(address);
  await waitForState(page, (now) => now.vertices === 25);
  await page.reload();
  await waitForState(page, (now) => now.vertices === 25);
  for (const other of ['gallery', 'licences', 'checked', 'speed', 'rhino', 'teaching']) {
    await page.goto(`./${other}.html`);
    await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  }
  expect(violations).toEqual([]);
  expect(elsewhere).toEqual([]);
});

test('the policy is active: forbidden actions are refused and recorded', async ({
  page,
  elsewhere,
  violations,
  complaints,
}) => {
  await openPage(page);
  const done = await page.evaluate(async () => {
    // In a later task: within its own task, a debugger may bypass the policy.
    await new Promise((next) => setTimeout(next));
    const script = document.createElement('script');
    script.textContent = 'window.wasRun = true';
    document.body.append(script);
    const attempts = {
      sent: () => fetch('http://elsewhere.invalid/', { method: 'POST', body: 'a roof' }),
      evaluated: () => new Function('return 1')(),
    };
    const succeeded = [];
    for (const [name, attempt] of Object.entries(attempts))
      await Promise.resolve()
        .then(attempt)
        .then(
          () => succeeded.push(name),
          () => {},
        );
    const status = document.getElementById('status') as HTMLElement;
    status.setAttribute('style', 'opacity: 0');
    if (window.wasRun) succeeded.push('run');
    return { succeeded, opacity: getComputedStyle(status).opacity };
  });
  expect(done).toEqual({ succeeded: [], opacity: '1' });
  await expect
    .poll(() => violations.map((text) => text.split(':')[0]).sort())
    .toEqual(['connect-src', 'script-src', 'script-src-elem', 'style-src-attr']);
  expect(elsewhere).toEqual([]);
  expect(complaints.filter((text) => !text.includes('Content Security Policy'))).toEqual([]);
  complaints.length = 0;

  // A worker has no policy, but the proxy records its requests.
  const worker = page.workers().find((one) => one.url().includes('solver-worker'));
  await worker?.evaluate(() => fetch('http://elsewhere.invalid/').catch(() => {}));
  expect(elsewhere).toEqual(['http://elsewhere.invalid/']);
  complaints.length = 0;
});
