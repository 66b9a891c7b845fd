import { describe, expect, it } from 'vitest';
import { Things } from '../../live/things';
import { View } from '../view';
import { standingOf, thingAt, thingsUnderWalls } from './things';

const square = [
  [-0.2, -0.2],
  [0.2, -0.2],
  [0.2, 0.2],
  [-0.2, 0.2],
];

function standing(number: number, y: number, high: number) {
  const piece = { color: null, corners: square, radius: 0, low: 0, high };
  return { number, name: `t${number}`, x: 0, y, heading: 0, height: 0, pieces: [piece] };
}

describe('a thing in an oblique view', () => {
  const view = new View(100, 400, 400, { turn: 0, oblique: true });
  const things = Things.NONE.after({
    run: 1,
    came: [standing(1, 0, 2), standing(2, 1, 0.5)],
    gone: [],
    left: 0,
  });
  const at = (y: number, z: number) => thingAt(things, new Map(), view.toPixel({ x: 0, y }, z), view, 0, 20);

  it('is taken at its foot, its sides and its top', () => {
    expect(at(-0.19, 0)).toBe(1);
    expect(at(-0.2, 1)).toBe(1);
    expect(at(0, 2)).toBe(1);
    expect(at(0, 2.5)).toBeNull();
  });

  it('hides those behind it from the pointer as it does from the eye', () => {
    expect(at(1, 0.5)).toBe(1); // the second's top is behind the first
    const first = things.after({ run: 1, came: [], gone: [1], left: 0 });
    expect(thingAt(first, new Map(), view.toPixel({ x: 0, y: 1 }, 0.5), view, 0, 20)).toBe(2);
  });

  it('is taken from above by its outline alone', () => {
    const above = new View(100, 400, 400);
    expect(thingAt(things, new Map(), above.toPixel({ x: 0, y: 1 }), above, 0, 20)).toBe(2);
    expect(thingAt(things, new Map(), above.toPixel({ x: 0, y: 0.5 }), above, 0, 20)).toBeNull();
  });
});

describe('walls of a map', () => {
  const map = {
    name: 'm',
    width: 8,
    height: 8,
    resolution: 0.5,
    originX: -2,
    originY: -2,
    colors: [],
    wallHeight: 0.6,
  };
  const cells = new Uint8Array(64);
  cells[8 * 4 + 4] = 100; // from (0, 0) to (0.5, 0.5)
  const all = Things.NONE.after({
    run: 1,
    came: [
      standing(1, 0, 0.5), // reaches into it
      standing(2, 0, 0.02), // likewise
      standing(3, 0, 0.6), // is as high
      standing(4, 1.5, 0.02), // is elsewhere
      standing(5, -0.4, 0.02), // likewise, but the circle around it reaches there
    ],
    gone: [],
    left: 0,
  });
  const under = (oblique: boolean, worldSide: number, moved = new Set<number>()) =>
    thingsUnderWalls(all, moved, map, cells, oblique, worldSide).map(({ number }) => number);

  it('are over what is lower and reaches into them, the lowest first', () => {
    expect(under(false, 4)).toEqual([2, 1]);
    expect(under(true, 4)).toEqual([2, 1]);
    expect(under(false, 4, new Set([2]))).toEqual([1]);
  });

  it('are over all that is lower and others stand in, in an oblique view', () => {
    const floor = {
      ...standing(6, 0, 0.02),
      x: -9,
      pieces: [{ ...standing(6, 0, 0.02).pieces[0]!, corners: square.map((c) => c.map((v) => 10 * v)) }],
    };
    const wide = Things.NONE.after({ run: 1, came: [floor], gone: [], left: 0 });
    expect(thingsUnderWalls(wide, new Set(), map, cells, true, 4)).toHaveLength(1);
    expect(thingsUnderWalls(wide, new Set(), map, cells, false, 4)).toHaveLength(0);
  });

  it('and things hide robots, but what is flat does not', () => {
    expect(standingOf(all, new Set(), 4, true).map(({ top }) => top)).toEqual([0.5, 0.6]);
  });
});
