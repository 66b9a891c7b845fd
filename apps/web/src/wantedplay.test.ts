import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { WantedPlay } from './wantedplay';

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

it('is what was wished until it is reported', () => {
  const wanted = new WantedPlay();
  expect(wanted.is(true)).toBe(true);
  wanted.wants(false);
  expect(wanted.is(true)).toBe(false);
  expect(wanted.is(false)).toBe(false);
  expect(wanted.is(true)).toBe(true); // as somebody else, or its end, has it
});

it('is as it is reported once the server had time to show what was wished', () => {
  const wanted = new WantedPlay();
  wanted.wants(true);
  vi.advanceTimersByTime(900);
  expect(wanted.is(false)).toBe(true);
  vi.advanceTimersByTime(200);
  expect(wanted.is(false)).toBe(false); // at the end of a recording nothing goes on
});
