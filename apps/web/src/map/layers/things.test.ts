import { describe, expect, it } from 'vitest';
import { Things } from '../../live/things';
import { View } from '../view';
import { thingAt } from './things';

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
