import { expect, it } from 'vitest';
import { rangeOf, Series } from './series';

function series(...points: [time: number, value: number | null][]): Series {
  const all = new Series();
  points.forEach(([time, value]) => all.push(time, value));
  return all;
}

it('the newest is at the right, the greatest at the top', () =>
  expect(series([0, 1], [30, 3], [60, 2]).path(100, 10, [1, 3], 60, 60)).toBe(
    'M0.0 10.0L50.0 0.0L100.0 5.0',
  ));

it('what does not change is in the middle', () =>
  expect(series([0, 7], [60, 7]).path(100, 10, [7, 7], 60, 60)).toBe('M0.0 5.0L100.0 5.0'));

it('says what it was', () => {
  const all = series([10, 1], [20, null], [30, 3]);
  expect([30, 25, 20, 15, 10, 9].map((time) => all.at(time))).toEqual([3, null, null, 1, 1, null]);
  expect(new Series().at(0)).toBeNull();
});

it('there is a gap where there was nothing', () =>
  expect(series([0, 0], [15, 1], [30, null], [45, 1], [60, 0]).path(100, 10, [0, 1], 60, 60)).toBe(
    'M0.0 10.0L25.0 0.0M75.0 0.0L100.0 10.0',
  ));

it('what was at a moment is shown, with lines that lead on to what came before and after', () => {
  const all = series([0, 100], [50, 1], [70, 2], [100, 3]);
  expect(all.range(10, 70)).toEqual([1, 2]);
  expect(all.path(60, 10, [1, 2], 70, 60)).toBe('M-10.0 -980.0L40.0 10.0L60.0 0.0L90.0 -10.0');
  expect(all.range(-50, -1)).toBeNull();
  expect(all.path(60, 10, [1, 2], -1, 60)).toBe('');
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

/** As if it had been told ten times a second. */
function long(seconds: number, value: (i: number) => number = (i) => i): Series {
  const all = new Series();
  for (let i = 0; i <= seconds * 10; i++) {
    all.push(i / 10, value(i));
  }
  return all;
}

const countIn = ({ times }: Series, from: number, until: number) =>
  times.filter((time) => time >= from && time <= until).length;

it('does not grow for ever, but reaches back to the beginning, as finely everywhere', () => {
  const all = long(7200);
  expect(all.times.length).toBeLessThanOrEqual(12_000);
  expect(all.at(0)).toBe(0);
  expect(countIn(all, 7140, 7200), 'of the last minute').toBe(601);
  const [early, late] = [countIn(all, 0, 1000), countIn(all, 6000, 7000)];
  expect(early).toBeGreaterThan(500);
  expect(late).toBeGreaterThanOrEqual(early);
  expect(late).toBeLessThan(5 * early);
});

it('keeps peaks, also those that nobody could see in a box', () => {
  const all = long(7200, (i) => (i === 12_345 ? 99 : i === 30_001 ? -99 : 0));
  expect(all.at(1234.5)).toBe(99);
  expect(all.at(3000.1)).toBe(-99);
  expect(all.range()).toEqual([-99, 99]);
  const path = all.path(240, 96, [-99, 99], 7200, 7200);
  expect(path).toMatch(/L41\.[12] 0\.0L/); // 240 · 1234.5 / 7200
  expect(path).toMatch(/L100\.0 96\.0L/);
  expect(path.split('L').length).toBeLessThan(4 * 2 * 240);
});

it('does not grow for ever in a minute either', () => {
  const all = new Series();
  for (let i = 0; i < 30_000; i++) {
    all.push(i / 1000, i);
  }
  expect(all.times.length).toBeGreaterThan(1000);
  expect(all.times.length).toBeLessThanOrEqual(12_000);
  expect(all.at(0)).toBe(0);
  expect(all.at(30)).toBeGreaterThan(29_980);
});

it('knows of gaps that are as old as that', () => {
  const all = long(7200);
  const gaps = new Series();
  all.times.forEach((time, i) => gaps.push(time, time > 100 && time < 200 ? null : all.values[i]!));
  for (let i = 72_001; i < 144_000; i++) {
    gaps.push(i / 10, i);
  }
  expect(gaps.at(150)).toBeNull();
  expect(gaps.path(240, 96, [0, 144_000], 400, 400).split('M')).toHaveLength(3);
});

it('keeps the last minute as it was when it takes over a long past', () => {
  const all = new Series();
  for (let i = 0; i <= 600; i++) {
    all.push(10_000 + i / 10, i);
  }
  const past = Array.from({ length: 20_000 }, (_, i) => i / 2);
  all.merge(past, past);
  expect(countIn(all, 10_000, 10_060), 'of the last minute').toBe(601);
  expect(all.times.length).toBeLessThanOrEqual(12_000);
  expect(all.at(0)).toBe(0);
});

it('several share a box', () => {
  const low = series([0, 0], [60, 10]);
  const high = series([0, 20], [60, 40]);
  const range = rangeOf([low, new Series(), high]);
  expect(range).toEqual([0, 40]);
  expect(low.path(100, 40, range!, 60, 60)).toBe('M0.0 40.0L100.0 30.0');
  expect(rangeOf([new Series()])).toBeNull();
});

it('of which all is known has no gaps where it was looked at elsewhere', () => {
  const all = new Series();
  all.play(30, 1, 1.5);
  all.play(50, 2, 1.5);
  expect(all.isWhole).toBe(false);
  all.learn([10, 20, 30, 40, 50, 60], [1, 2, 3, null, 5, 6]);
  expect(all.isWhole).toBe(true);
  all.play(20, 2, 1.5);
  all.play(55, 5.5, 1.5);
  expect(all.times).toEqual([10, 20, 30, 40, 50, 55, 60]);
  expect(all.values).toEqual([1, 2, 3, null, 5, 5.5, 6]);
});
