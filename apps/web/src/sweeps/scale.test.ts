import { describe, expect, it } from 'vitest';
import type { SweepCombination } from '../api/messages';
import { duration, scaleOf } from './scale';

function combination(mean: number, half: number | null, outside: number[] = []): SweepCombination {
  return {
    label: String(mean),
    ended: 5,
    outcomes: [],
    metrics: {
      way: {
        count: 5,
        measured: 5,
        mean,
        low: half === null ? null : mean - half,
        high: half === null ? null : mean + half,
        box: { low: mean, first: mean, median: mean, third: mean, high: mean, outside },
      },
    },
  };
}

describe('the scale of a metric', () => {
  it('has room for the intervals and outliers of all combinations', () => {
    const scale = scaleOf('way', [combination(10, 2), combination(20, 1, [28])])!;
    const { least, greatest } = scale.axis;
    expect(least).toBeLessThanOrEqual(8);
    expect(greatest).toBeGreaterThanOrEqual(28);
    expect([least, (least + greatest) / 2, greatest].map(scale.at)).toEqual([0, 0.5, 1]);
  });

  it('distinguishes values that are nearly the same', () => {
    const { axis } = scaleOf('way', [combination(100.1, null), combination(100.4, null)])!;
    expect(axis.ticks[0]!.text).not.toBe(axis.ticks.at(-1)!.text);
  });

  it('puts the only value in the middle', () => {
    expect(scaleOf('way', [combination(3, null)])!.at(3)).toBe(0.5);
  });

  it('is none where nothing was measured', () => {
    expect(scaleOf('speed', [combination(3, null)])).toBeNull();
  });
});

describe('a duration', () => {
  it.each([
    [0.4, '0 s'],
    [59.6, '1 min 0 s'],
    [125, '2 min 5 s'],
    [9_999, '2 h 46 min'],
  ])('of %d s is %s', (seconds, words) => expect(duration(seconds)).toBe(words));
});
