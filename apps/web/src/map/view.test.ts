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

  describe('that is turned', () => {
    const quarter = new View(20, 100, 50, { turn: Math.PI / 2, oblique: false });

    it('has the x axis up, a quarter turn counter-clockwise', () => {
      expect(quarter.toPixel({ x: 1, y: 0 }).px).toBeCloseTo(100);
      expect(quarter.toPixel({ x: 1, y: 0 }).py).toBeCloseTo(30);
      expect(quarter.toPixel({ x: 0, y: 1 }).px).toBeCloseTo(80);
    });

    it.each([
      [0.3, false],
      [2, true],
      [-3, true],
      [Math.PI / 2, false],
    ])('by %s (oblique: %s) finds the places of its pixels', (turn, oblique) => {
      const view = new View(33, 100, 50, { turn, oblique });
      const { x, y } = view.toMap(view.toPixel({ x: -3.2, y: 7.1 }, 1.5), 1.5);
      expect(x).toBeCloseTo(-3.2);
      expect(y).toBeCloseTo(7.1);
    });

    it.each([false, true])(
      '(oblique: %s) keeps what it is turned around, zoomed at and put around',
      (oblique) => {
        const at = { px: 333, py: 77 };
        const view = new View(20, 100, 50, { turn: 0.4, oblique });
        const place = view.toMap(at);
        for (const next of [
          view.turned(1, at),
          view.zoomed(2, at),
          view.turned(-2, at).as({ turn: 1, oblique: true }, at),
        ]) {
          expect(next.toPixel(place).px).toBeCloseTo(at.px);
          expect(next.toPixel(place).py).toBeCloseTo(at.py);
        }
        expect(view.turned(1, at).turn).toBeCloseTo(1.4);
        expect(view.turned(3, at).turn).toBeCloseTo(3.4 - 2 * Math.PI);
        const { px, py } = view.centred({ x: 3, y: 4 }, 800, 600).toPixel({ x: 3, y: 4 });
        expect(px).toBeCloseTo(400);
        expect(py).toBeCloseTo(300);
      },
    );

    it('fits all corners of the map', () => {
      const view = View.fit(office, 800, 600, { turn: 0.7, oblique: false });
      const pixels = [office.minX, office.maxX].flatMap((x) =>
        [office.minY, office.maxY].map((y) => view.toPixel({ x, y })),
      );
      const across = pixels.map(({ px }) => px);
      const down = pixels.map(({ py }) => py);
      expect(Math.min(...down)).toBeCloseTo(16);
      expect(Math.max(...down)).toBeCloseTo(584);
      expect(Math.min(...across)).toBeGreaterThan(16);
      expect(Math.min(...across) + Math.max(...across)).toBeCloseTo(800);
    });

    it.each([false, true])('(oblique: %s) leads a canvas to the map and back', (oblique) => {
      const view = new View(20, 100, 50, { turn: 0.4, oblique });
      const steps: number[][] = [];
      const canvas = { transform: (...matrix: number[]) => steps.push(matrix) };
      view.enter(canvas as unknown as CanvasRenderingContext2D);
      view.leave(canvas as unknown as CanvasRenderingContext2D);
      const apply = ([a, b, c, d, e, f]: number[], [x, y]: [number, number]): [number, number] => [
        a! * x + c! * y + e!,
        b! * x + d! * y + f!,
      ];
      const { px, py } = view.toPixel({ x: 2, y: 3 });
      expect(apply(steps[0]!, [2, 3])).toEqual([px, py].map((value) => expect.closeTo(value) as number));
      expect(apply(steps[1]!, [px, py])).toEqual([2, 3].map((value) => expect.closeTo(value) as number));
    });
  });

  describe('that is oblique', () => {
    const view = new View(20, 100, 50, { turn: 0.8, oblique: true });

    it('draws heights upward, and depths shorter', () => {
      const [foot, head] = [view.toPixel({ x: 1, y: 2 }), view.toPixel({ x: 1, y: 2 }, 1.5)];
      expect(head.px).toBeCloseTo(foot.px);
      expect(foot.py - head.py).toBeCloseTo(1.5 * 20 * view.rise);
      const far = new View(20, 0, 0, { turn: 0, oblique: true }).toPixel({ x: 0, y: 1 });
      expect(far.py).toBeCloseTo(-20 * view.squeeze);
      expect(view.squeeze ** 2 + view.rise ** 2).toBeCloseTo(1); // one angle
    });

    it('draws what is raised as if it lay farther away', () => {
      const raised = view.toPixel(view.raised({ x: 1, y: 2, heading: 0 }, 1.5));
      const { px, py } = view.toPixel({ x: 1, y: 2 }, 1.5);
      expect(raised.px).toBeCloseTo(px);
      expect(raised.py).toBeCloseTo(py);
      expect(new View(20, 0, 0).raised({ x: 1, y: 2, heading: 3 }, 1.5)).toEqual({ x: 1, y: 2, heading: 3 });
    });

    it('fits walls, too', () => {
      const fitted = View.fit(office, 800, 300, { turn: 0, oblique: true }, 2);
      expect(fitted.toPixel({ x: 0, y: office.maxY }, 2).py).toBeGreaterThanOrEqual(16 - 1e-9);
      expect(fitted.toPixel({ x: 0, y: office.minY }).py).toBeLessThanOrEqual(284 + 1e-9);
    });
  });
});
