import { expect, it } from 'vitest';
import { rangeOf, Series, short, spanOf } from './series';

function series(...points: [time: number, value: number | null][]): Series {
  const all = new Series();
  points.forEach(([time, value]) => all.push(time, value));
  return all;
}

it('the newest is at the right, the greatest at the top', () =>
  expect(series([0, 1], [30, 3], [60, 2]).path(100, 10)).toBe('M0.0 10.0L50.0 0.0L100.0 5.0'));

it('what does not change is in the middle', () =>
  expect(series([0, 7], [60, 7]).path(100, 10)).toBe('M0.0 5.0L100.0 5.0'));

it('tells what it was', () => {
  const all = series([10, 1], [20, null], [30, 3]);
  expect([0, 5, 10, 15, 20].map((ago) => all.at(ago))).toEqual([3, null, null, 1, 1]);
  expect(all.at(21)).toBeNull();
  expect(new Series().at(0)).toBeNull();
});

it('there is a gap where there was nothing', () =>
  expect(series([0, 0], [15, 1], [30, null], [45, 1], [60, 0]).path(100, 10)).toBe(
    'M0.0 10.0L25.0 0.0M75.0 0.0L100.0 10.0',
  ));

it('what is older than a minute is forgotten', () => {
  const all = series([0, 100], [50, 1], [70, 2], [100, 3]);
  expect(all.range).toEqual([1, 3]);
  expect(all.newest).toBe(3);
});

it('the same moment counts once, and time that goes back begins anew', () => {
  const all = series([5, 1], [5, 2]);
  expect(all.newest).toBe(1);
  all.push(1, 9);
  expect(all.range).toEqual([9, 9]);
});

it('does not grow for ever', () => {
  const all = new Series();
  for (let i = 0; i < 5000; i++) {
    all.push(i / 1000, i);
  }
  expect(all.range).toEqual([3800, 4999]);
});

it('several share a box', () => {
  const low = series([0, 0], [60, 10]);
  const high = series([0, 20], [60, 40]);
  const range = rangeOf([low, new Series(), high]);
  expect(range).toEqual([0, 40]);
  expect(low.path(100, 40, range)).toBe('M0.0 40.0L100.0 30.0');
  expect(high.path(100, 40, range)).toBe('M0.0 20.0L100.0 0.0');
  expect(rangeOf([])).toBeNull();
});

it('a box begins small, and grows', () => {
  const young = series([3, 0], [8, 1]);
  expect(spanOf([young, new Series()])).toBe(10);
  expect(young.path(100, 10, young.range, 10)).toBe('M50.0 10.0L100.0 0.0');
  expect(spanOf([young, series([0, 0], [11, 0])])).toBe(30);
  expect(spanOf([series([0, 0], [31, 0])])).toBe(60);
});

it('nothing is nothing', () => {
  expect(new Series().path(100, 10)).toBe('');
  expect(series([1, null]).range).toBeNull();
});

it.each([
  [0, '0.00'],
  [-0.1234, '-0.123'],
  [1.234, '1.23'],
  [12.34, '12.3'],
  [1234.5, '1235'],
  [1e6, '1.0e+6'],
  [0.00001, '1.0e-5'],
])('%d is %s', (value, text) => expect(short(value)).toBe(text));
