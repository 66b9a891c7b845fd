import { expect, it } from 'vitest';
import type { Frame } from './frame';
import { Trails } from './trails';

/** @param looks 0 is the present */
function frame(run: number, time: number, x: number, looks = 0): Frame {
  return {
    run,
    time,
    past: looks > 0,
    looks,
    robots: [{ pose: { x, y: 0, heading: 0 } }],
  } as unknown as Frame;
}

/** Told by the server: of a robot that was at these places. */
function told(times: number[], xs: number[], driven = times.map((_, i) => i > 0)) {
  return { robots: [{ times, xs, ys: xs.map(() => 0), driven }] };
}

it('a trail has where a robot was in the last 30 seconds', () => {
  const trails = new Trails();
  for (let time = 0; time <= 60; time++) {
    trails.add(frame(1, time, time));
  }
  expect(trails.of(0)?.x[0]).toBe(30);
  expect(trails.of(0)?.x.at(-1)).toBe(60);
});

it('a robot that stands leaves no trail', () => {
  const trails = new Trails();
  for (let time = 0; time <= 10; time++) {
    trails.add(frame(1, time, 0.001 * time));
  }
  expect(trails.of(0)?.x).toHaveLength(1);
});

it('a robot that was put elsewhere did not drive there', () => {
  const trails = new Trails();
  trails.add(frame(1, 0, 0));
  trails.add(frame(1, 0.1, 0.1));
  trails.add(frame(1, 9, 0.1)); // stands
  trails.add(frame(1, 9, 8)); // is put there while paused
  trails.add(frame(1, 9.1, 8.1));
  expect(trails.of(0)?.driven).toEqual([false, true, false, true]);
});

it('a robot in a run at full speed drove what lies between two frames', () => {
  const trails = new Trails();
  trails.add(frame(1, 0, 0));
  trails.add(frame(1, 5, 4));
  expect(trails.of(0)?.driven).toEqual([false, true]);
});

it('another run begins without trails', () => {
  const trails = new Trails();
  trails.add(frame(1, 0, 0));
  trails.add(frame(1, 1, 1));
  trails.add(frame(2, 0, 5));
  expect(trails.of(0)?.x).toEqual([5]);
});

it('who looks at another time sees no trail from where it looked before', () => {
  const trails = new Trails();
  for (let tenth = 0; tenth <= 20; tenth++) {
    expect(trails.add(frame(1, 10 + tenth / 10, tenth, 1))).toBe(tenth === 0);
  }
  expect(trails.of(0)?.x).toHaveLength(21);
  expect(trails.add(frame(1, 12.1, 7, 2))).toBe(true); // near as it is, and however fast it is played
  expect(trails.of(0)?.x).toEqual([7]);
  expect(trails.add(frame(1, 12.2, 7.1, 2))).toBe(false);
  expect(trails.of(0)?.x).toEqual([7, 7.1]);
  trails.add(frame(1, 12, 3, 3));
  expect(trails.of(0)?.x).toEqual([3]);
  expect(trails.add(frame(1, 12.1, 3.1))).toBe(true); // the present
  expect(trails.of(0)?.x).toEqual([3.1]);
});

it('nobody drove straight over what was passed over, as a recording is played fast', () => {
  const trails = new Trails();
  trails.add(frame(1, 10, 0, 1));
  expect(trails.add(frame(1, 10.9, 0.5, 1))).toBe(false);
  expect(trails.add(frame(1, 60, 0.9, 1))).toBe(true);
  expect(trails.of(0)?.driven).toEqual([false]);
  trails.add(frame(1, 61.5, 30, 1));
  expect(trails.of(0)?.driven).toEqual([false, false]);
});

it('what was before is as the server knows it', () => {
  const trails = new Trails();
  const first = frame(1, 40, 10, 1);
  trails.add(first);
  trails.add(frame(1, 40.1, 10.1, 1));
  trails.learn(told([9, 20, 30, 40], [1, 5, 8, 10]), first);
  expect(trails.of(0)?.x).toEqual([5, 8, 10, 10.1]); // without what is too old
  expect(trails.of(0)?.time).toEqual([20, 30, 40, 40.1]);
  expect(trails.of(0)?.driven).toEqual([true, true, true, true]);
});

it('what the server says of where somebody looked before counts no more', () => {
  const trails = new Trails();
  const first = frame(1, 40, 10, 1);
  trails.add(first);
  trails.add(frame(1, 70, 3, 2));
  trails.learn(told([39, 40], [9, 10]), first);
  expect(trails.of(0)?.x).toEqual([3]);
});

it('who was put elsewhere after what the server knows did not drive there', () => {
  const trails = new Trails();
  const first = frame(1, 40, 10);
  trails.add(first);
  trails.add(frame(1, 40.1, 20));
  trails.learn(told([39, 39.9], [9, 9.9]), first);
  expect(trails.of(0)?.x).toEqual([9, 9.9, 10, 20]);
  expect(trails.of(0)?.driven).toEqual([false, true, true, false]);
});
