import { describe, expect, it } from 'vitest';
import { clockTime } from '../format';
import { newest, shownOf, spanWords, ticksBefore, ticksIn, viewOf, zoomed, moved } from './window';

describe('without a view', () => {
  it.each([
    [60, 8, 10],
    [60, 12, 30],
    [60, 31, 60],
    [60, 500, 60],
    [10, 500, 10],
    [300, 500, 300],
    [300, 70, 120],
    [1800, 1801, 1800],
    [Infinity, 70, 120],
    [Infinity, 5000, 5000],
  ])('of at most %d s, while %d are known, it shows %d', (chosen, known, shown) =>
    expect(newest(chosen, { from: 100, until: 100 + known })).toEqual({
      from: 100 + known - shown,
      until: 100 + known,
    }),
  );

  it('goes along with what is new', () => {
    expect(shownOf(null, 10, { from: 0, until: 50 })).toEqual({ from: 40, until: 50 });
    expect(shownOf({ seconds: 5, until: null }, 10, { from: 0, until: 50 })).toEqual({ from: 45, until: 50 });
    expect(shownOf({ seconds: 5, until: 30 }, 10, { from: 0, until: 50 })).toEqual({ from: 25, until: 30 });
  });
});

describe('of 100 s', () => {
  const known = { from: 0, until: 100 };
  const shown = { from: 40, until: 80 };

  it('what the pointer is at stays there', () => {
    expect(zoomed(shown, 0.5, 50, known)).toEqual({ seconds: 20, until: 65 });
    expect(zoomed(shown, 1.25, 60, known)).toEqual({ seconds: 50, until: 85 });
  });

  it('what reaches to the end goes on with it', () => {
    expect(zoomed(shown, 2, 60, known)).toEqual({ seconds: 80, until: null });
    expect(zoomed({ from: 40, until: 100 }, 0.5, 100, known)).toEqual({ seconds: 30, until: null });
    expect(moved(shown, 20, known)).toEqual({ seconds: 40, until: null });
    expect(moved(shown, 999, known)).toEqual({ seconds: 40, until: null });
  });

  it('nothing before the first is shown, nor more than there is, nor less than a second', () => {
    expect(moved(shown, -60, known)).toEqual({ seconds: 40, until: 40 });
    expect(zoomed(shown, 99, 60, known)).toEqual({ seconds: 100, until: null });
    expect(viewOf({ from: 50, until: 50.2 }, known)).toEqual({ seconds: 1, until: 50.6 });
  });
});

const ticks = (seconds: number) => ticksBefore(seconds).map(({ text }) => text);

it.each([
  [10, '−10 s −5 s'],
  [30, '−30 s −20 s −10 s'],
  [60, '−60 s −40 s −20 s'],
  [120, '−2 min −1 min'],
  [300, '−4 min −2 min'],
  [1800, '−30 min −20 min −10 min'],
  [5000, '−60 min −30 min'],
  [20_000, '−4 h −2 h'],
  [1, '−1 s −0.5 s'],
])('%d s have ticks at %s', (seconds, texts) => expect(ticks(seconds).join(' ')).toBe(texts));

it('ticks are where their time is', () =>
  expect(ticksBefore(300).map(({ part }) => part)).toEqual([1 - 240 / 300, 1 - 120 / 300]));

it('a part of the past has times of the run, but for where its end stands', () =>
  expect(ticksIn({ from: 59, until: 69 }, clockTime)).toEqual([
    { part: 0.1, text: '1:00.0' },
    { part: 0.6, text: '1:05.0' },
  ]));

it.each([
  [10, '10 s'],
  [60, '60 s'],
  [2.34, '2.3 s'],
  [300, '5 min'],
  [1800, '30 min'],
  [9000, '2.5 h'],
])('%d s are %s', (seconds, words) => expect(spanWords(seconds)).toBe(words));
