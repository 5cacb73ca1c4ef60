// How the page writes and reads numbers, lengths and keys.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import cases from '../../data/words.json' with { type: 'json' };
import { count, duration, length, limit, number, part, ratio } from '../../../www/ui/format.ts';
import { coordinate, decimalsFor, readLength } from '../../../www/ui/format.ts';
import { valueInWords } from '../../../www/store/colours/measures.ts';
import { chordOf, digitOf, keyName } from '../../../www/ui/keys.ts';
import type { FaceMeasure } from '../../../www/solver/types.ts';

const MEASURE = { id: '', label: '', words: '', met: '' };
const PLAIN = { toleranced: false, curvature: false, signed: false };

test('numbers are worded as by the engine, whose test reads the same cases', () => {
  const words: Record<string, (...given: never[]) => string> = {
    ...{ number, length, limit, part, count },
    value: (value: number, unit: FaceMeasure['unit'], units: string, like?: number) =>
      valueInWords({ ...MEASURE, ...PLAIN, unit }, value, units, like),
  };
  for (const { of, given, words: expected } of cases)
    assert.equal(words[of](...(given as never[])), expected, `${of} of ${JSON.stringify(given)}`);
});

test('a number has three digits, a true minus sign, and a power of ten where that is shorter', () => {
  const cases = { 1.2345: '1.23', [-0.5]: '−0.500', 12345: '12345', 0: '0', 2.5e-7: '2.50e−7' };
  for (const [value, text] of Object.entries(cases)) assert.equal(number(Number(value)), text);
  assert.equal(number(3e7), '3.00e7');
  assert.equal(number(NaN), '–');
});

test('a number that rounds to a power of ten is written in full', () => {
  // 999.7 used to be shown as 1.00e+3, and 99.7 ms as 1.0e+2 ms.
  assert.deepEqual([number(999.4), number(999.7), number(-999.7)], ['999', '1000', '−1000']);
  assert.deepEqual([duration(99.4), duration(99.7), duration(9.96)], ['99 ms', '100 ms', '10 ms']);
});

test('metres below a decimetre are shown in millimetres, other units are kept', () => {
  assert.equal(length(0.0421, 'm'), '42.1 mm');
  assert.equal(length(0.0421, 'ft'), '0.0421 ft');
  assert.equal(length(1e-9, 'm'), '0 mm');
  assert.equal(length(2, ''), '2.00');
  // Beside another length, both have the same unit.
  assert.equal(length(0.0421, 'm', 3), '0.0421 m');
  assert.equal(limit(0.005, 'm'), '5 mm');
  assert.equal(limit(5e-6, ''), '5e−6');
});

test('an irrelevant length is shown alike beside any other length', () => {
  // Beside a length in metres an exact shape used to be off by "4.99e−12 m", and later by
  // "< 0.001 mm" beside "0 mm".
  assert.equal(length(4.99e-12, 'm', 0.105), '0 m');
  assert.equal(length(-4.99e-12, 'm'), '0 mm');
  assert.equal(length(4.99e-12, 'mm'), '0 mm');
  assert.equal(length(0.0000421, 'm', 3), '0.042 mm');
  assert.equal(length(4.99e-12, 'ft', 3), '4.99e−12 ft');
  assert.equal(length(0, 'm', 3), '0 m');
});

test('fractions, ratios and counts are shown in words', () => {
  assert.deepEqual([part(0), part(0.004), part(0.5)], ['0 %', '< 1 %', '50 %']);
  assert.deepEqual([ratio(1.5), ratio(Infinity), ratio(NaN)], ['1.5000', '∞', '–']);
  assert.equal(count(1, 'vertex', 'vertices'), '1 vertex');
  assert.equal(count(12345, 'face'), '12\u2009345 faces');
});

test('lengths are read as people type them', () => {
  assert.deepEqual(readLength('1,5', 'm'), { by: false, length: 1.5 });
  assert.deepEqual(readLength('1/4', 'm'), { by: false, length: 0.25 });
  assert.deepEqual(readLength('20cm', 'm'), { by: false, length: 0.2 });
  assert.deepEqual(readLength('+-0.5', 'm'), { by: true, length: -0.5 });
  assert.throws(() => readLength('far', 'm'), /“far” is not a length/);
  assert.throws(() => readLength('1/0', 'm'), /is not a length/);
});

test('coordinates have as many decimals as their mesh needs', () => {
  assert.deepEqual(
    [decimalsFor(20), decimalsFor(2e-6), decimalsFor(1e9), decimalsFor(0)],
    [4, 11, 0, 3],
  );
  assert.equal(coordinate(-0.00001, 3), '0.000');
});

test('letter keys are identified by character, digit keys by position', () => {
  const press = (key: string, more: Partial<KeyboardEvent> = {}) => {
    const held = { ctrlKey: false, shiftKey: false, metaKey: false };
    return { key, code: '', ...held, ...more } as KeyboardEvent;
  };
  assert.equal(chordOf(press('z', { ctrlKey: true })), 'Ctrl+Z');
  assert.equal(chordOf(press('Z', { metaKey: true, shiftKey: true })), 'Ctrl+Shift+Z');
  // The character already implies Shift.
  assert.equal(chordOf(press('?', { shiftKey: true })), '?');
  assert.equal(digitOf(press('&', { code: 'Digit1' })), '1');
  assert.equal(digitOf(press('!', { code: 'Digit1', shiftKey: true })), 'Shift+1');
  assert.equal(digitOf(press('7', { code: 'Numpad7' })), 'Numpad7');
  assert.equal(digitOf(press('Home', { code: 'Numpad7' })), '');
  assert.equal(keyName('Ctrl+Shift+Z'), 'Ctrl+Shift+Z');
  assert.equal(keyName(' '), 'Space');
});
