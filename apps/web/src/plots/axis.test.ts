import { expect, it } from 'vitest';
import { axisOf, meant, withError } from './axis';
import { numberText } from '../format';

it.each([
  [33.8, 152, '0 50 100 150 200'],
  [0.0381, 0.0394, '0.0380 0.0385 0.0390 0.0395'],
  [-1.2, 0.9, '-2 -1 0 1'],
  [-0.04, 0.13, '-0.1 0.0 0.1 0.2'],
  [0, 1, '0.0 0.5 1.0'],
  [1000, 1001, '1000.0 1000.5 1001.0'],
  [0.1, 0.7, '0.0 0.2 0.4 0.6 0.8'],
  [0, 3e-5, '0 1e-5 2e-5 3e-5'],
  [0, 5e6, '0 2e+6 4e+6 6e+6'],
])('from %d to %d it has %s', (least, greatest, texts) => {
  const axis = axisOf(least, greatest);
  expect(axis.ticks.map(({ text }) => text).join(' ')).toBe(texts);
  expect(axis.least).toBeLessThanOrEqual(least);
  expect(axis.greatest).toBeGreaterThanOrEqual(greatest);
});

it.each([
  [7, 7],
  [0, 0],
  [0.3, 0.3 + 1e-12],
])('what does not change (%d, %d) has one', (least, greatest) =>
  expect(axisOf(least, greatest).ticks).toEqual([{ value: least, text: numberText(least) }]),
);

it.each([
  [0.039, 6.1e-4, '0.0390 ± 0.0006'],
  [0.039, 1.2e-4, '0.03900 ± 0.00012'],
  [17.51, 0.902, '17.5 ± 0.9'],
  [17.28, 1.37, '17.3 ± 1.4'],
  [76.73, 37.22, '77 ± 37'],
  [0, 0, '0 ± 0'],
  [-0.5, 0.0296, '-0.50 ± 0.03'],
  [1234567, 40000, '(1.23 ± 0.04)e6'],
  [0.000123, 0.00002, '(1.23 ± 0.20)e-4'],
])('%d with an error of %d is %s', (value, error, text) => expect(withError(value, error)).toBe(text));

it.each([
  [1e-13, '°/s', 0],
  [-0.0009, '°/s', 0],
  [0.002, '°/s', 0.002],
  [-9e-6, 'm', 0],
  [1e-6, 'm²', 1e-6],
  [1e-17, '', 0],
  [1e-7, 'T', 1e-7],
])('%d %s means %d', (value, unit, is) => expect(meant(value, unit)).toBe(is));
