import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { WantedSpeed } from './wantedspeed';

/** A run that answers when it is told to. */
class SlowRun {
  readonly asked: string[] = [];
  private answers: ((done: boolean) => void)[] = [];

  ask = (speed: string) => {
    this.asked.push(speed);
    return new Promise<boolean>((resolve) => this.answers.push(resolve));
  };

  async answer(done = true) {
    this.answers.shift()!(done);
    await vi.advanceTimersByTimeAsync(0);
  }
}

let run: SlowRun;
let wanted: WantedSpeed;

beforeEach(() => {
  vi.useFakeTimers();
  run = new SlowRun();
  wanted = new WantedSpeed(run.ask);
});

afterEach(() => vi.useRealTimers());

it('fast presses count from what was wanted, and the last one is what the run hears last', async () => {
  for (let press = 0; press < 3; press++) {
    void wanted.change(1, 1);
  }
  await run.answer();
  expect(run.asked).toEqual(['2', '10']);
  await run.answer();
  void wanted.change(-1, 1); // the run has not told yet that it goes at 10
  expect(run.asked).toEqual(['2', '10', '5']);
});

it('counts from what the run reports once it had time to do so', async () => {
  void wanted.change(1, 1);
  await run.answer();
  vi.advanceTimersByTime(1000);
  void wanted.change(1, 50); // somebody else made it faster
  expect(run.asked).toEqual(['2', '100']);
});

it('a refusal is forgotten', async () => {
  const first = wanted.change(1, 1);
  await run.answer(false);
  expect(await first).toBe(false);
  void wanted.change(1, 1);
  expect(run.asked).toEqual(['2', '2']);
});
