// Choosing the files that a scene names and that are missing.

import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { offersToChoose } from '../../../www/documents/missing-files.ts';
import { Openings } from '../../../www/documents/openings.ts';
import type { Files } from '../../../www/documents/files.ts';
import type { NamedBytes } from '../../../www/solver/types.ts';
import type { Actions } from '../../../www/store/actions.ts';
import type { Offer } from '../../../www/ui/controls/alerts.tsx';

/** A scene without a file that it names, as which the user chooses others, one after the other. */
async function asked(context: TestContext, missing: string, ...choices: string[]) {
  context.after(() => {
    for (const name of ['document', 'HTMLButtonElement']) Reflect.deleteProperty(globalThis, name);
  });
  /** A file dialog. */
  class Input {
    files: File[] = [];
    onchange = () => {};
    append() {}
    setAttribute() {}
    toggleAttribute() {}
    click() {
      this.files = [new File([], choices.shift() ?? '')];
      this.onchange();
    }
  }
  globalThis.document = { createElement: () => new Input() } as unknown as Document;
  globalThis.HTMLButtonElement = class {} as typeof HTMLButtonElement;
  /** The names of the files that are opened. */
  const opened: string[] = [];
  const open = async (given: NamedBytes[]) => opened.push(...given.map(({ name }) => name));
  /** What is told, and offered with it. */
  const told: [string, Offer[]][] = [];
  const reportErrors = (promise: Promise<unknown>, ...offers: Offer[]) =>
    promise.catch((error: Error) => void told.push([error.message, offers]));
  const actions = { reportErrors, ask: { missingFiles: async () => [missing] } };
  const files = { openings: new Openings(), open };
  const [offer] = await offersToChoose(
    [],
    actions as unknown as Actions,
    files as unknown as Files,
    {},
  );
  const press = async ({ action }: Offer) => {
    action();
    await new Promise((done) => setTimeout(done));
    await files.openings.coming;
  };
  await press(offer);
  return { opened, told, press };
}

test('after a file of another format, another one can be chosen', async (context) => {
  // The offer was gone: the scene had to be opened again.
  const { opened, told, press } = await asked(context, 'ground.obj', 'plan.off', 'plan.obj');
  const [[message, offers]] = told;
  assert.equal(message, 'plan.off is of another format: the scene needs a .obj file.');
  assert.deepEqual(
    offers.map(({ label }) => label),
    ['Choose ground.obj …'],
  );
  await press(offers[0]);
  assert.deepEqual(opened, ['ground.obj']);
});

test('a missing file without an ending is named', async (context) => {
  // “the scene needs a  file”
  const { told } = await asked(context, 'site/ground', 'plan.obj');
  assert.deepEqual(
    told.map(([message]) => message),
    ['plan.obj is of another format: the scene needs ground, a file without an ending.'],
  );
});
