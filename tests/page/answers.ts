// Answers of the workers that come when a test lets them: what the page does meanwhile is tested
// without waiting for a time.

import type { Page } from '@playwright/test';

declare global {
  interface Window {
    /** The names of the calls whose answers are held back, and what would bring those that came. */
    held?: { names: string[]; came: { by: string; bring: () => void }[] };
  }
}

/** Runs in the page, before its own scripts. */
function holdThem() {
  const held: NonNullable<Window['held']> = (window.held = { names: [], came: [] });
  window.Worker = class extends Worker {
    #names = new Map<unknown, string>();
    #own;
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      this.#own = options?.name;
    }
    override postMessage(call: { id?: number; name: string }, ...rest: unknown[]) {
      if (call.id !== undefined) this.#names.set(call.id, call.name);
      super.postMessage(call, ...(rest as [StructuredSerializeOptions?]));
    }
    override set onmessage(hear: (event: MessageEvent) => void) {
      super.onmessage = (event) => {
        const name = this.#names.get(event.data.id);
        if (!name || !held.names.includes(name)) return hear(event);
        held.came.push({ by: `${this.#own}: ${name}`, bring: () => hear(event) });
      };
    }
  };
}

/** Lets a test hold back answers in the documents that the page opens from now on. */
export async function holdingAnswers(page: Page) {
  await page.addInitScript(holdThem);
  return {
    /** Holds back the answers to calls with these names. */
    hold: (...names: string[]) =>
      page.evaluate((them) => void Object.assign(window.held ?? {}, { names: them }), names),
    /** Waits until an answer of a worker is held back. */
    come: (from: string) =>
      page.waitForFunction((by) => window.held?.came.some((one) => one.by === by), from),
    /** Brings what was held back, and holds back nothing more. */
    release: () =>
      page.evaluate(() => {
        const { held } = window;
        if (!held) return;
        held.names = [];
        for (const { bring } of held.came.splice(0)) bring();
      }),
  };
}
