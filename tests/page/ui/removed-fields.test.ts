// What is typed in a field that is removed is not reported.

import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { options, type VNode } from 'preact';
import { dropRemovedInput } from '../../../www/ui/removed-fields.ts';

test('only a removed field reports nothing: one that stays does', (context: TestContext) => {
  // What was typed in it was dropped, too, if something else was removed at that moment.
  const listeners: ((event: object) => void)[] = [];
  const page = { addEventListener: (_: string, listen: () => void) => listeners.push(listen) };
  globalThis.document = page as unknown as Document;
  context.after(() => Reflect.deleteProperty(globalThis, 'document'));
  dropRemovedInput();
  const [removed, stays] = [new EventTarget(), new EventTarget()];
  options.unmount?.({ type: 'input', __e: removed } as unknown as VNode);
  options.unmount?.({ type: 'p', __e: new EventTarget() } as unknown as VNode);
  const isReported = (target: EventTarget) => {
    let reported = true;
    const stopImmediatePropagation = () => (reported = false);
    for (const listen of listeners) listen({ target, stopImmediatePropagation });
    return reported;
  };
  assert.deepEqual([isReported(removed), isReported(stays)], [false, true]);
});
