import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Repeater } from './repeater';

describe('a repeater', () => {
  let heard: string[] = [];
  let answer: (() => void)[] = [];
  let failures: unknown[] = [];
  let refuse = false;
  let repeater: Repeater<string>;

  beforeEach(() => {
    vi.useFakeTimers();
    heard = [];
    answer = [];
    failures = [];
    refuse = false;
    repeater = new Repeater(
      (what) => {
        heard.push(what);
        return refuse ? Promise.reject(new Error(what)) : new Promise((resolve) => answer.push(resolve));
      },
      (reason) => failures.push(reason),
    );
  });

  afterEach(() => vi.useRealTimers());

  async function answered() {
    answer.shift()!();
    await vi.advanceTimersByTimeAsync(0);
  }

  it('says at once what is new, and again ten times a second', async () => {
    repeater.tell('go');
    expect(heard).toEqual(['go']);
    for (let tenth = 0; tenth < 5; tenth++) {
      await answered();
      await vi.advanceTimersByTimeAsync(100);
    }
    expect(heard).toEqual(['go', 'go', 'go', 'go', 'go', 'go']);
  });

  it('waits until it was heard, then says the newest only', async () => {
    repeater.tell('go');
    repeater.tell('faster');
    repeater.tell('stop');
    await vi.advanceTimersByTimeAsync(1000);
    expect(heard).toEqual(['go']);
    await answered();
    expect(heard).toEqual(['go', 'stop']);
  });

  it('says nothing any more when it was stopped', async () => {
    repeater.tell('go');
    let stopped = false;
    void repeater.stop().then(() => (stopped = true));
    await vi.advanceTimersByTimeAsync(1000);
    expect(stopped).toBe(false);
    await answered();
    expect(stopped).toBe(true);
    await vi.advanceTimersByTimeAsync(1000);
    expect(heard).toEqual(['go']);
    repeater.tell('again');
    expect(heard).toEqual(['go', 'again']);
  });

  it('gives up when nobody wants to hear it', async () => {
    refuse = true;
    repeater.tell('go');
    await vi.advanceTimersByTimeAsync(1000);
    expect(heard).toEqual(['go']);
    expect(failures).toEqual([new Error('go')]);
  });
});
