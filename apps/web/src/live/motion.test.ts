import { describe, expect, it } from 'vitest';
import type { Frame, Pose } from './frame';
import { blend, isBlending, wrap } from './motion';

function arrived(at: number, pose: Pose | null, time = at / 1000) {
  return { at, frame: { time, robots: [{ pose }], things: [] } as unknown as Frame };
}

describe('between two frames', () => {
  const before = arrived(0, { x: 0, y: 0, heading: 3 });
  const newest = arrived(50, { x: 1, y: 0.5, heading: -3 });

  it('robots are on their way, turning the short way round', () => {
    const [pose] = blend(before, newest, 75);
    expect(pose?.x).toBeCloseTo(0.5);
    expect(pose?.y).toBeCloseTo(0.25);
    expect(Math.abs(pose!.heading)).toBeCloseTo(Math.PI);
  });

  it('robots arrive when the next frame is due, and stay there', () => {
    expect(blend(before, newest, 100)[0]).toEqual(newest.frame.robots[0]!.pose);
    expect(blend(before, newest, 1000)[0]).toEqual(newest.frame.robots[0]!.pose);
    expect(isBlending(before, newest, 99)).toBe(true);
    expect(isBlending(before, newest, 100)).toBe(false);
  });

  it('robots that were put somewhere jump', () => {
    expect(blend(before, arrived(50, { x: 9, y: 0, heading: 0 }), 75)[0]?.x).toBe(9);
  });

  it('robots jump when frames are rare, or the first', () => {
    expect(blend(before, arrived(500, { x: 1, y: 0, heading: 0 }), 510)[0]?.x).toBe(1);
    expect(blend(null, newest, 60)[0]?.x).toBe(1);
    expect(blend(arrived(0, null), newest, 60)[0]?.x).toBe(1);
    expect(blend(before, arrived(50, null), 60)[0]).toBeNull();
  });

  it('robots jump when the run is so fast that nobody knows where they went', () => {
    const later = arrived(50, { x: 1, y: 0, heading: 0 }, 0.8);
    expect(blend(before, later, 75)[0]?.x).toBe(1);
    expect(isBlending(before, later, 75)).toBe(false);
    expect(blend(before, arrived(50, { x: 1, y: 0, heading: 0 }, 0.7), 75)[0]?.x).toBeCloseTo(0.5);
  });
});

describe('an angle', () => {
  it.each([
    [0, 0],
    [Math.PI, -Math.PI],
    [-Math.PI, -Math.PI],
    [3 * Math.PI + 0.5, -Math.PI + 0.5],
    [-7, -7 + 2 * Math.PI],
  ])('of %f is %f', (angle, wrapped) => expect(wrap(angle)).toBeCloseTo(wrapped));
});
