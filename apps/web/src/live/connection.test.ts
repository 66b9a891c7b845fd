import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Bundles } from './connection';

const FRAME = new ArrayBuffer(8);

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function bundles() {
  const taken: unknown[] = [];
  return { taken, line: new Bundles((data) => taken.push(data)) };
}

it('words come with the frame behind them, in their order', () => {
  const { taken, line } = bundles();
  for (const round of [1, 2]) {
    line.take(`run ${round}`);
    line.take('details');
    expect(taken).toEqual([]);
    line.take(FRAME);
    expect(taken.splice(0)).toEqual([`run ${round}`, 'details', FRAME]);
  }
});

it('words without a frame come a little later', () => {
  const { taken, line } = bundles();
  line.take(FRAME);
  line.take('reach');
  vi.advanceTimersByTime(20);
  line.take('things');
  expect(taken).toEqual([FRAME]);
  vi.advanceTimersByTime(20); // counted from the first
  expect(taken).toEqual([FRAME, 'reach', 'things']);
});

it('events wait for nothing, but for what was said before them', () => {
  const { taken, line } = bundles();
  line.take(FRAME);
  line.take('{"events":{}}');
  expect(taken).toEqual([FRAME, '{"events":{}}']);
  line.take('reach');
  line.take('{"events":{"run":1}}');
  expect(taken.slice(2)).toEqual(['reach', '{"events":{"run":1}}']);
});

it('a hidden page is informed at once', () => {
  vi.stubGlobal('document', { hidden: true });
  const { taken, line } = bundles();
  line.take('reach');
  expect(taken).toEqual(['reach']);
  vi.unstubAllGlobals();
});

it('a first frame is waited for longer, but not for ever', () => {
  const { taken, line } = bundles();
  line.take('run');
  vi.advanceTimersByTime(200);
  expect(taken).toEqual([]);
  vi.runAllTimers();
  expect(taken).toEqual(['run']);
});

it('what can not be taken keeps nothing else back', () => {
  const reported = vi.fn();
  vi.stubGlobal('reportError', reported);
  const taken: unknown[] = [];
  const line = new Bundles((data) => {
    if (data === 'nonsense') {
      throw new Error();
    }
    taken.push(data);
  });
  line.take('nonsense');
  line.take(FRAME);
  expect(taken).toEqual([FRAME]);
  expect(reported).toHaveBeenCalledOnce();
  vi.unstubAllGlobals();
});
