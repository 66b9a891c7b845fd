import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Beginning } from './connection';

const FRAME = new ArrayBuffer(8);

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('what a line brings before its first frame comes with that, in its order', () => {
  const taken: unknown[] = [];
  const beginning = new Beginning((data) => taken.push(data));
  beginning.take('run');
  beginning.take('details');
  expect(taken).toEqual([]);
  beginning.take(FRAME);
  expect(taken).toEqual(['run', 'details', FRAME]);
  beginning.take('events');
  vi.runAllTimers();
  expect(taken).toEqual(['run', 'details', FRAME, 'events']);
});

it('a first frame that does not come is not waited for', () => {
  const taken: unknown[] = [];
  const beginning = new Beginning((data) => taken.push(data));
  beginning.take('run');
  vi.runAllTimers();
  beginning.end();
  expect(taken).toEqual(['run']);
  beginning.take('details');
  expect(taken).toEqual(['run', 'details']);
});
