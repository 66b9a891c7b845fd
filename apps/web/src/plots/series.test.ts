import { expect, it } from 'vitest';
import { rangeOf, Series, spanOf } from './series';

function series(...points: [time: number, value: number | null][]): Series {
  const all = new Series();
  points.forEach(([time, value]) => all.push(time, value));
  return all;
}

it('the newest is at the right, the greatest at the top', () =>
  expect(series([0, 1], [30, 3], [60, 2]).path(100, 10, [1, 3])).toBe('M0.0 10.0L50.0 0.0L100.0 5.0'));

it('what does not change is in the middle', () =>
  expect(series([0, 7], [60, 7]).path(100, 10, [7, 7])).toBe('M0.0 5.0L100.0 5.0'));

it('tells what it was', () => {
  const all = series([10, 1], [20, null], [30, 3]);
  expect([30, 25, 20, 15, 10, 9].map((time) => all.at(time))).toEqual([3, null, null, 1, 1, null]);
  expect(new Series().at(0)).toBeNull();
});

it('there is a gap where there was nothing', () =>
  expect(series([0, 0], [15, 1], [30, null], [45, 1], [60, 0]).path(100, 10, [0, 1])).toBe(
    'M0.0 10.0L25.0 0.0M75.0 0.0L100.0 10.0',
  ));

it('what was at a moment is shown without what came before and after', () => {
  const all = series([0, 100], [50, 1], [70, 2], [100, 3]);
  expect(all.range(10, 70)).toEqual([1, 2]);
  expect(all.path(60, 10, [1, 2], 70)).toBe('M40.0 10.0L60.0 0.0');
  expect(all.range(-50, -1)).toBeNull();
  expect(all.path(60, 10, [1, 2], -1)).toBe('');
});

it('what is as old as the newest, or older, counts no more', () => {
  const all = series([5, 1], [5, 2], [1, 9]);
  expect(all.at(5)).toBe(1);
  expect(all.range()).toEqual([1, 1]);
});

it('takes over what somebody else knows, and keeps its own', () => {
  const all = series([10, 1], [11, 2]);
  all.merge([0, 5, 11, 12], [7, null, 8, 9]);
  expect([0, 5, 10, 11, 12].map((time) => all.at(time))).toEqual([7, null, 1, 2, 9]);
  all.push(12, 10);
  expect(all.at(12)).toBe(9);
});

it('joins no pieces of a recording between which nothing was played', () => {
  const all = new Series();
  [10, 11, 12, 40, 41, 20, 21, 50].forEach((time) => all.play(time, time, 1.5));
  const known = [10, 12, 15, 20, 21, 30, 40, 45, 50].map((time) => all.at(time));
  expect(known).toEqual([10, 12, null, 20, 21, null, 40, null, 50]);
  expect(all.path(60, 10, [0, 60], 60, 60).split('M').length - 1, 'pieces').toBe(4);
});

it('does not grow for ever, but reaches back to the beginning', () => {
  const all = new Series();
  for (let i = 0; i < 20_000; i++) {
    all.push(i / 10, i);
  }
  const points = all.path(100, 10, [0, 20_000], 2000, 2000).split('L').length;
  expect(points).toBeLessThanOrEqual(4000);
  expect(all.at(0)).toBe(0);
  expect(all.path(60, 10, [0, 20_000], 1999.9).split('L').length, 'of the last minute').toBe(601);
});

it('does not grow for ever in a minute either', () => {
  const all = new Series();
  for (let i = 0; i < 10_000; i++) {
    all.push(i / 1000, i);
  }
  const points = all.path(100, 10, [0, 10_000]).split('L').length;
  expect(points).toBeGreaterThan(1000);
  expect(points).toBeLessThanOrEqual(4000);
  expect(all.at(0)).toBe(0);
  expect(all.at(10)).toBeGreaterThan(9990);
});

it('keeps the last minute as it was when it takes over a long past', () => {
  const all = new Series();
  for (let i = 0; i <= 600; i++) {
    all.push(10_000 + i / 10, i);
  }
  const past = Array.from({ length: 20_000 }, (_, i) => i / 2);
  all.merge(past, past);
  expect(all.path(60, 10, [0, 600]).split('L').length, 'of the last minute').toBe(601);
  expect(all.path(100, 10, [0, 600], 10_060, 20_000).split('L').length).toBeLessThanOrEqual(4000);
  expect(all.at(0)).toBe(0);
});

it('several share a box', () => {
  const low = series([0, 0], [60, 10]);
  const high = series([0, 20], [60, 40]);
  const range = rangeOf([low, new Series(), high]);
  expect(range).toEqual([0, 40]);
  expect(low.path(100, 40, range!)).toBe('M0.0 40.0L100.0 30.0');
  expect(rangeOf([new Series()])).toBeNull();
});

it.each([
  [8, 10],
  [12, 30],
  [31, 60],
  [500, 60],
])('of %d seconds a box shows %d', (known, shown) =>
  expect(spanOf([series([0, 1], [known, 1]), new Series()], known)).toBe(shown),
);
