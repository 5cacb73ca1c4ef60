// What a field for a number shows while the user types and the solver answers.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { amountField } from '../../../www/ui/controls/fields.ts';

/** The parts of a number field that `amountField` uses. */
class NumberField extends EventTarget {
  value = '';
  setAttribute() {}
  append() {}
  get validity() {
    return { valid: !Number.isNaN(Number(this.value)) };
  }
  get valueAsNumber() {
    return Number(this.value);
  }
  type(text: string) {
    this.value = text;
    this.dispatchEvent(new Event('input'));
  }
}

test('a value that is being typed is not replaced when a run ends', (context) => {
  context.after(() => {
    for (const name of ['document', 'HTMLButtonElement']) Reflect.deleteProperty(globalThis, name);
  });
  globalThis.document = { createElement: () => new NumberField() } as unknown as Document;
  globalThis.HTMLButtonElement = class {} as unknown as typeof HTMLButtonElement;
  const sent: number[] = [];
  const { field: made, show } = amountField('Shape weight', (value) => sent.push(value));
  const field = made as unknown as NumberField;
  show(1000);
  field.type('2');
  // It used to become 1000 again, and the next digit 10005.
  show(1000);
  field.type(`${field.value}5`);
  field.dispatchEvent(new Event('change'));
  assert.deepEqual(sent, [25]);
  show(30);
  assert.equal(field.value, '30');
  // Typed and taken back: browsers report no change.
  field.type('31');
  show(40);
  field.type('30');
  field.dispatchEvent(new Event('blur'));
  assert.equal(field.value, '40');
  assert.deepEqual(sent, [25]);
});
