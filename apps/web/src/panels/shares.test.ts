import { expect, it } from 'vitest';
import { movedTo, sharesIn, tracksOf } from './shares';

const LEAST = [150, 120, 120];

it('what one gains the next one loses', () => {
  expect(movedTo([300, 300, 400], 0, 400, LEAST)).toEqual([40, 20, 40]);
  expect(movedTo([300, 300, 400], 1, 200, LEAST)).toEqual([30, 20, 50]);
});

it('none gets smaller than it may be', () => {
  expect(movedTo([300, 300, 400], 0, 10_000, LEAST)).toEqual([48, 12, 40]);
  expect(movedTo([300, 300, 400], 0, -50, LEAST)).toEqual([15, 45, 40]);
});

it('are tracks of a grid', () => {
  expect(tracksOf([60.5, 39.5], [220, 160])).toBe('minmax(220px, 60.5fr) minmax(160px, 39.5fr)');
});

it('are kept as words, and anything else is none', () => {
  const shares = movedTo([300, 300, 400], 0, 345, LEAST);
  expect(sharesIn(shares.join(' '), 3)).toEqual(shares);
  for (const nonsense of [null, '', '50 50', '50 -50 100', '1 2 x', '0 50 50', '500 1 1']) {
    expect(sharesIn(nonsense, 3)).toBeNull();
  }
});
