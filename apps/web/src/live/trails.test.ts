import { expect, it } from 'vitest';
import type { Frame } from './frame';
import { Trails } from './trails';

function frame(run: number, time: number, x: number, past = false): Frame {
  return { run, time, past, speed: 1, robots: [{ pose: { x, y: 0, heading: 0 } }] } as unknown as Frame;
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
    trails.add(frame(1, 10 + tenth / 10, tenth, true));
  }
  expect(trails.of(0)?.x).toHaveLength(21);
  trails.add(frame(1, 40, 7, true));
  expect(trails.of(0)?.x).toEqual([7]);
  trails.add(frame(1, 40.1, 7.1, true));
  expect(trails.of(0)?.x).toEqual([7, 7.1]);
  trails.add(frame(1, 12, 3, true));
  expect(trails.of(0)?.x).toEqual([3]);
  trails.add(frame(1, 12.1, 3.1, false)); // the present
  expect(trails.of(0)?.x).toEqual([3.1]);
});
