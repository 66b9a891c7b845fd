import { describe, expect, it } from 'vitest';
import { nextSpeed, speedIndex, speeds } from './speeds';

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

  it('goes up and down, and no farther than there is', () => {
    expect(nextSpeed(1, 1)).toBe('2');
    expect(nextSpeed(1, -1)).toBe('0.5');
    expect(nextSpeed(100, 1)).toBe('max');
    expect(nextSpeed(Infinity, 1)).toBe('max');
    expect(nextSpeed(Infinity, -1)).toBe('100');
    expect(nextSpeed(0.1, -1)).toBe('0.1');
  });
});
