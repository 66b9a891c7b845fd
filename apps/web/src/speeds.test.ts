import { describe, expect, it } from 'vitest';
import { nameOf, nextSpeed, speedIndex, speeds, speedsWith } from './speeds';

describe('a speed', () => {
  it('is found among those offered', () => {
    expect(speeds[speedIndex(1)]).toBe('1');
    expect(speeds[speedIndex(Infinity)]).toBe('max');
    expect(speeds[speedIndex(0.1)]).toBe('0.1');
  });

  it('between two is the lower one', () => {
    expect(speeds[speedIndex(7)]).toBe('5');
    expect(speeds[speedIndex(0.01)]).toBe('0.1');
  });

  it('that is not offered finds its place among those that are', () => {
    expect(speedsWith('5')).toEqual(speeds);
    expect(speedsWith('3').slice(3, 7)).toEqual(['1', '2', '3', '5']);
  });

  it('is called what the server calls it', () => {
    expect(nameOf(Infinity)).toBe('max');
    expect(nameOf(Math.fround(0.3))).toBe('0.3');
    expect(nameOf(20)).toBe('20');
  });

  it('goes up and down, and no farther than there is', () => {
    expect(nextSpeed(1, 1)).toBe('2');
    expect(nextSpeed(1, -1)).toBe('0.5');
    expect(nextSpeed(100, 1)).toBe('max');
    expect(nextSpeed(Infinity, 1)).toBe('max');
    expect(nextSpeed(Infinity, -1)).toBe('100');
    expect(nextSpeed(0.1, -1)).toBe('0.1');
  });
});
