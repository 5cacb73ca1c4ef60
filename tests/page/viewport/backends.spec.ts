// WebGPU where it works, otherwise WebGL2: which module is loaded, and that the pictures are equal.

import type { Page } from '@playwright/test';
import type { Picture } from '../picture.ts';
import {
  coloursOfView,
  expect,
  keptOffline,
  looks,
  openPage,
  pictureOf,
  test,
  waitForState,
} from '../support.ts';

// WebGPU fills all pixels, in software.
test.use({ fresh: true, viewport: { width: 720, height: 450 } });

/** Records the variants of the view's module that a page loads. */
function watchModules(page: Page) {
  const loaded = new Set<string>();
  page.on('request', (request) => {
    const [, backend] = /view-(\w+)-[^/]*\.wasm$/.exec(request.url()) ?? [];
    if (backend) loaded.add(backend);
  });
  return loaded;
}

/** Waits until the view has drawn with a backend. */
async function drawnWith(page: Page, backend: string) {
  await waitForState(page, (now, wanted) => now.renderer === wanted, backend);
  await expect(page.locator('#first-picture')).toHaveCount(0);
  await expect.poll(() => coloursOfView(page)).toBeGreaterThan(50);
}

/** The view alone, as pixels. */
async function pictureAlone(page: Page) {
  // The moving overlays would be compared too.
  await page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync('#viewport ~ * { visibility: hidden !important }');
    document.adoptedStyleSheets.push(sheet);
  });
  return pictureOf(page);
}

/** The fraction of pixels whose colours differ by more than rounding. */
function differing(a: Picture, b: Picture) {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  let count = 0;
  for (let at = 0; at < a.pixels.length; at += a.channels) {
    const change = [0, 1, 2].map((i) => Math.abs(a.pixels[at + i] - b.pixels[at + i]));
    if (Math.max(...change) > 3) count += 1;
  }
  return (count * a.channels) / a.pixels.length;
}

test('both backends draw the same picture, each with its own module', looks, async ({ page }) => {
  const pictures = [];
  for (const [demand, backend] of [
    ['webgl2', 'webgl2'],
    ['webgpu', 'webgpu'],
  ]) {
    const loaded = watchModules(page);
    await openPage(page, `renderer=${demand}`);
    await drawnWith(page, backend);
    expect([...loaded]).toEqual([backend]);
    pictures.push(await pictureAlone(page));
    page.removeAllListeners('request');
  }
  const [one, other] = pictures;
  expect(differing(one, other)).toBeLessThan(0.0005);
});

/** Possible faults of WebGPU, and whether each shows only after its module has loaded. */
const faults: Record<string, [cause: () => void, modules: string[]]> = {
  'no adapter': [
    () => {
      GPU.prototype.requestAdapter = async () => null;
    },
    ['webgl2'],
  ],
  'an adapter that never answers': [
    () => {
      GPU.prototype.requestAdapter = () => new Promise(() => {});
    },
    ['webgl2'],
  ],
  'no device': [
    () => {
      GPUAdapter.prototype.requestDevice = () => Promise.reject(new DOMException('out of order'));
    },
    ['webgpu', 'webgl2'],
  ],
  'a device that is lost at once': [
    () => {
      const { requestDevice } = GPUAdapter.prototype;
      GPUAdapter.prototype.requestDevice = async function (...args) {
        const device = await requestDevice.apply(this, args);
        setTimeout(() => device.destroy());
        return device;
      };
    },
    ['webgpu', 'webgl2'],
  ],
  'pictures that stay empty': [
    () => {
      GPUQueue.prototype.submit = () => {};
    },
    ['webgpu', 'webgl2'],
  ],
};
for (const [fault, [cause, modules]] of Object.entries(faults)) {
  test(`WebGL2 draws if WebGPU has ${fault}`, looks, async ({ page }) => {
    const loaded = watchModules(page);
    await page.addInitScript(cause);
    await openPage(page);
    await drawnWith(page, 'webgl2');
    expect([...loaded]).toEqual(modules);
    await expect(page.getByText('No 3D view')).toBeHidden();
  });
}

test('WebGPU is used by default if it works', looks, async ({ page }) => {
  const loaded = watchModules(page);
  await openPage(page);
  await drawnWith(page, 'webgpu');
  expect([...loaded]).toEqual(['webgpu']);
});

/** Lets WebGL2 say that it draws with a graphics card. */
const graphicsCard = () => {
  const { getParameter } = WebGL2RenderingContext.prototype;
  const UNMASKED_RENDERER = 0x9246;
  WebGL2RenderingContext.prototype.getParameter = function (name: number) {
    return name === UNMASKED_RENDERER ? 'NVIDIA H200' : getParameter.call(this, name);
  };
};

test('WebGL2 on a graphics card goes before WebGPU by software', looks, async ({ page }) => {
  // The page took 350 ms a frame where 17 were possible.
  const loaded = watchModules(page);
  await page.addInitScript(graphicsCard);
  await openPage(page);
  await drawnWith(page, 'webgl2');
  expect([...loaded]).toEqual(['webgl2']);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toContainText('Drawn by WebGL2 with NVIDIA H200');
});

/** The cached variants of the view's module. */
const keptViews = (page: Page) =>
  page.evaluate(async () => {
    const names = (await caches.keys()).filter((name) => name.startsWith('shape-up'));
    const opened = await Promise.all(names.map((name) => caches.open(name)));
    const requests = (await Promise.all(opened.map((cache) => cache.keys()))).flat();
    const backends = requests.map(({ url }) => /view-(\w+)-[^/]*\.wasm$/.exec(url)?.[1]);
    return backends.filter(Boolean).sort();
  });

test.describe('without a network', () => {
  test.use({ serviceWorkers: 'allow' });

  test('the module in use is cached, and another one once it is requested', async ({
    page,
    context,
  }) => {
    for (const [backend, kept] of [
      ['webgpu', ['webgpu']],
      ['webgl2', ['webgl2', 'webgpu']],
    ]) {
      await context.setOffline(false);
      await openPage(page, `renderer=${backend}`);
      await waitForState(page, (now, wanted) => now.renderer === wanted, backend);
      await keptOffline(page);
      await expect.poll(() => keptViews(page)).toEqual(kept);
      await context.setOffline(true);
      await openPage(page, `renderer=${backend}`);
      await waitForState(page, (now, wanted) => now.renderer === wanted, backend);
    }
  });
});
