import { describe, expect, it } from 'vitest';
import { View } from './view';

const office = { minX: -31.475, minY: -7.8, maxX: 31.475, maxY: 7.8 };

describe('a view', () => {
  it('has y up on the map and down on the canvas', () => {
    const view = new View(20, 100, 50);
    expect(view.toPixel({ x: 1, y: 2 })).toEqual({ px: 120, py: 10 });
    expect(view.toMap({ px: 120, py: 10 })).toEqual({ x: 1, y: 2 });
  });

  it('that fits shows all of the map, in the middle', () => {
    const view = View.fit(office, 800, 600);
    const upperLeft = view.toPixel({ x: office.minX, y: office.maxY });
    const lowerRight = view.toPixel({ x: office.maxX, y: office.minY });
    expect(upperLeft.px).toBeCloseTo(16);
    expect(lowerRight.px).toBeCloseTo(784);
    expect(upperLeft.py + lowerRight.py).toBeCloseTo(600);
  });

  it('zooms around the pointer', () => {
    const at = { px: 333, py: 77 };
    const view = new View(20, 100, 50);
    const zoomed = view.zoomed(3, at);
    expect(zoomed.scale).toBe(60);
    expect(zoomed.toMap(at).x).toBeCloseTo(view.toMap(at).x);
    expect(zoomed.toMap(at).y).toBeCloseTo(view.toMap(at).y);
  });

  it('zooms only so far, and stays where it is then', () => {
    const at = { px: 10, py: 10 };
    const near = new View(20, 0, 0).zoomed(1e9, at);
    expect(near.scale).toBe(800);
    expect(near.zoomed(2, at)).toEqual(near);
    expect(near.zoomed(1e-9, at).scale).toBe(1);
  });

  it('moves with the hand', () => {
    const moved = new View(20, 0, 0).panned(7, -9);
    expect(moved.toPixel({ x: 0, y: 0 })).toEqual({ px: 7, py: -9 });
  });

  it('can be put around a robot', () => {
    const view = new View(20, 0, 0).centred({ x: 3, y: 4 }, 800, 600);
    expect(view.toPixel({ x: 3, y: 4 })).toEqual({ px: 400, py: 300 });
  });
});
