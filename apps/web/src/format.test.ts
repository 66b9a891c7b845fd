import { expect, it } from 'vitest';
import { age, brief, clockTime, degrees, factor, numberText, unsigned } from './format';
import texts from './number-texts.json';

it.each([
  [0, '0:00.0'],
  [9.99, '0:09.9'],
  [0.3, '0:00.3'],
  [61.25, '1:01.2'],
  [3600, '1:00:00.0'],
  [7325.5, '2:02:05.5'],
])('%f seconds are %s', (seconds, text) => expect(clockTime(seconds)).toBe(text));

it.each([
  [5.9, '5 s'],
  [119, '119 s'],
  [120, '2 min'],
  [7199, '119 min'],
  [7200, '2 h'],
])('what was %f s ago is %s old', (seconds, text) => expect(age(seconds)).toBe(text));

it.each([
  [1, '1×'],
  [0.1, '0.1×'],
  [0.9533, '0.95×'],
  [41.7, '42×'],
  [Infinity, 'max'],
])('a factor of %f is %s', (value, text) => expect(factor(value)).toBe(text));

it.each([
  [0, '0°'],
  [-0.0001, '0°'],
  [Math.PI / 2, '90°'],
  [-Math.PI, '180°'],
  [-Math.PI / 2, '-90°'],
])('%f radians are %s', (radians, text) => expect(degrees(radians)).toBe(text));

it.each([
  ['go(-1.631998817773008,-1.947434467801798)', 'go(-1.632,-1.947)'],
  ['0.46695204089382697, 2.0000001, 1.25', '0.467, 2, 1.25'],
  ['1.23456e-7 and r1.12345a', '1.23e-7 and r1.12345a'],
  ['call(3,-4.718629821801143,1.3877787807814457E-17)', 'call(3,-4.719,0)'],
  ['0.0012345, -0.00000000001, 2.5E7, 1.2.34567', '0.00123, 0, 25000000, 1.2.34567'],
  ['at (3.50, -1.960), not at 3.56666.', 'at (3.50, -1.960), not at 3.567.'],
  ['prey-1', 'prey-1'],
])('%s is %s in brief', (words, text) => expect(brief(words)).toBe(text));

it.each([
  ['at (-0.00, 1.00, -0°)', 'at (0.00, 1.00, 0°)'],
  ['-0.05 m, -0.5°, 10-0, r-0', '-0.05 m, -0.5°, 10-0, r-0'],
  ['-0', '0'],
])('%s is %s', (words, told) => expect(unsigned(words)).toBe(told));

it('writes numbers as Java does', () => {
  expect(texts.length).toBeGreaterThan(1000);
  for (const [value, text] of texts as [number, string][]) {
    expect(numberText(value), `${value}`).toBe(text);
  }
});
