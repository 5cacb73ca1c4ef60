// The page writes numbers and lengths as the engine does, by the module of words.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import cases from '../../data/words.json' with { type: 'json' };
import { readNumber } from '../../../www/ui/components/number-input.tsx';
import * as words from '../../../www/ui/words.ts';

test('words are those of Rust, whose test reads the same cases', () => {
  for (const { of, given, words: expected } of cases) {
    const found = words[of as 'number'](...(given as [number]));
    assert.equal(found, expected, `${of} of ${JSON.stringify(given)}`);
  }
});

test('a typed length is read, or refused in words', () => {
  const { by, length } = words.readLength('+-20cm', 'm');
  assert.deepEqual([by, length], [true, -0.2]);
  assert.throws(() => words.readLength('far', 'm'), /“far” is not a length/);
  assert.throws(() => words.measured(1, 'furlongs', 'm'), /"furlongs" is no unit of a measure/);
});

test('a whole number with a comma or a point is refused: to some it is a thousand', () => {
  for (const text of ['1,000', '1.000', '2,5'])
    assert.deepEqual(readNumber(text, { isWhole: true }), [
      null,
      'Expected a whole number, such as 1000.',
    ]);
  assert.deepEqual(readNumber('1 000', { isWhole: true }), [1000, '']);
  assert.deepEqual(readNumber('1,000', { unit: 'm' }), [1, '']);
});

test('what is compared, and units, cross as they are in Rust', () => {
  const { lengths, unit } = words.comparedLengths(Float64Array.of(0.05, -0.03), 'm');
  assert.deepEqual([lengths, unit], [['50.000', '−30.000'], 'mm']);
  assert.deepEqual(words.unitsOfLength(), ['m', 'cm', 'mm', 'ft', 'in']);
  assert.deepEqual([words.metresOf('ft'), words.metresOf('ell')], [0.3048, undefined]);
  assert.deepEqual([words.rhinoUnit('cm'), words.rhinoUnit('ell')], ['Centimeters', undefined]);
});

test('what is missing on the page is missing in Rust', () => {
  assert.equal(words.length(0.05, 'm', null), '50.0 mm');
  assert.equal(words.measured(0.05, 'length', 'm', null), '50.0 mm');
  assert.deepEqual(
    [words.rangeIn(null, 5, 'm'), words.rangeIn(null, null, 'm')],
    ['up to 5.00 m', 'any'],
  );
  assert.deepEqual([words.number(NaN), words.signedPart(-0)], ['–', '0.0 %']);
  assert.deepEqual([words.lengthOrZero(-1e-12, 100), words.lengthOrZero(-1, 100)], [0, -1]);
  const { symbol, factor } = words.writtenUnit('per-length', 'mm', 1);
  assert.deepEqual([symbol, factor], ['1/m', 1000]);
});
