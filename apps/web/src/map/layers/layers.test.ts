import { describe, expect, it, vi } from 'vitest';
import { BROKEN, NOTHING, TOO_CLOSE, type Pose, type RobotState } from '../../live/frame';
import { bgrOf, Dots } from './dots';
import type { Scene } from '../scene';
import { ellipse } from './estimates';
import { poolCells } from './floor';
import { compose } from './frames';
import { gridStep } from './grid';
import { nameOf } from './names';
import { drawMotion, motionOf } from './paths';
import { handleOf, radius } from './robots';
import { eachBeam, strengthOf } from './scans';

const footprint = [
  [-0.2, -0.2],
  [0.2, -0.2],
  [0.2, 0.2],
  [-0.2, 0.2],
];

describe('an ellipse of certainty', () => {
  const pose = { x: 0, y: 0, heading: 0 };

  it('lies along the axis that is less certain', () => {
    const { major, minor, angle } = ellipse({ pose, headingDeviation: 0, xx: 0.01, xy: 0, yy: 0.04 });
    expect(major).toBeCloseTo(2.45 * 0.2);
    expect(minor).toBeCloseTo(2.45 * 0.1);
    expect(angle).toBeCloseTo(Math.PI / 2);
  });

  it('is a line when x and y are wrong together', () => {
    const { major, minor, angle } = ellipse({ pose, headingDeviation: 0, xx: 0.02, xy: 0.02, yy: 0.02 });
    expect(major).toBeCloseTo(2.45 * 0.2);
    expect(minor).toBeCloseTo(0);
    expect(angle).toBeCloseTo(Math.PI / 4);
  });
});

describe('a robot', () => {
  it('is drawn to scale when it is large enough to be seen', () => {
    expect(radius(footprint, 100)).toBeCloseTo(Math.hypot(0.2, 0.2));
  });

  it('is drawn larger on a large map', () => {
    expect(radius(footprint, 5) * 5).toBeCloseTo(9);
  });

  it('has its handle in front of it', () => {
    const handle = handleOf({ x: 1, y: 1, heading: Math.PI / 2 }, footprint, 100);
    expect(handle.x).toBeCloseTo(1);
    expect(handle.y).toBeGreaterThan(1.3);
  });
});

describe('the motion of a robot', () => {
  it.each([
    [0.6, 0],
    [-0.3, 0],
    [0, 0.4],
    [-0.2, -0.5],
  ])('is what many small steps give, %d m/s ahead and %d m/s to the left', (speed, sideways) => {
    const turnRate = -0.9;
    let [x, y, heading] = [1, 2, 0.4];
    const small = 1e-4;
    for (let time = 0; time < 2; time += small) {
      x += small * (speed * Math.cos(heading) - sideways * Math.sin(heading));
      y += small * (speed * Math.sin(heading) + sideways * Math.cos(heading));
      heading += small * turnRate;
    }
    const end = motionOf({ x: 1, y: 2, heading: 0.4 }, speed, turnRate, sideways).at(-1)!;
    expect(end.x).toBeCloseTo(x, 3);
    expect(end.y).toBeCloseTo(y, 3);
    const straight = motionOf({ x: 0, y: 0, heading: Math.PI / 2 }, 0.5, 0).at(-1)!;
    expect(straight.x).toBeCloseTo(0);
    expect(straight.y).toBeCloseTo(1);
  });
});

describe('where a robot goes next', () => {
  const driving = { pose: { x: 1, y: 2, heading: 0 }, speed: 0.5, sideways: 0, turnRate: 0, localPath: null };

  /** Lines that are drawn, by their places. */
  function drawn(robots: Partial<RobotState>[], selected?: number) {
    const lines: [number, number][][] = [];
    const context = {
      beginPath: () => lines.push([]),
      lineTo: (x: number, y: number) => lines.at(-1)!.push([x, y]),
      stroke: () => undefined,
    };
    drawMotion(
      context as unknown as CanvasRenderingContext2D,
      {
        info: { robots: robots.map(() => ({ color: '#0072b2' })) },
        frame: { robots },
        view: { scale: 100 },
        selected,
      } as unknown as Scene,
    );
    return lines;
  }

  it('is the way that its local planner means to go', () => {
    const localPath = Int32Array.of(1000, 2000, 1500, 2250, 1750, 2750);
    expect(drawn([{ ...driving, localPath }])).toEqual([
      [
        [1, 2],
        [1.5, 2.25],
        [1.75, 2.75],
      ],
    ]);
    expect(drawn([{ ...driving, localPath, speed: 0 }])).toHaveLength(1);
  });

  it('is where its motion takes it when nobody reports it', () => {
    const [arc] = drawn([driving, { ...driving, speed: 0 }, { ...driving, pose: null }]);
    expect(arc![0]).toEqual([1, 2]);
    expect(arc!.at(-1)).toEqual([2, 2]);
  });

  it('is drawn of the selected one only where there are many', () => {
    expect(drawn(Array<Partial<RobotState>>(61).fill(driving), 3)).toHaveLength(1);
    expect(drawn(Array<Partial<RobotState>>(60).fill(driving), 3)).toHaveLength(60);
  });
});

describe('the name of a robot', () => {
  it('says whether it is real, and for how long it has been silent', () => {
    expect(nameOf('ann', undefined)).toBe('ann');
    expect(nameOf('ann', { proxy: true, silence: null })).toBe('ann ◈');
    expect(nameOf('ann', { proxy: false, silence: 12 })).toBe('ann ◆ 12 s');
  });
});

describe('laser scans', () => {
  it('are as strong as they can be when they are few', () => {
    expect(strengthOf(1)).toBe(1);
    expect(strengthOf(5)).toBe(1);
  });

  it('hide the floor no more when they are many', () => {
    const seen = (scans: number) => (1 - 0.09 * strengthOf(scans)) ** scans;
    for (const scans of [10, 100, 1000]) {
      expect(seen(scans)).toBeGreaterThan(0.95 * seen(5));
    }
  });
});

it('a grid has lines at round distances, neither dense nor sparse', () => {
  for (let scale = 1; scale < 800; scale *= 1.3) {
    expect(gridStep(scale) * scale).toBeGreaterThanOrEqual(40);
    expect(gridStep(scale) * scale).toBeLessThanOrEqual(101);
  }
});

describe('cells that share a pixel', () => {
  const [free, wall, unknown] = [0, 100, 255];

  it('are a wall when one of them is', () => {
    const cells = Uint8Array.of(free, free, unknown, free, free, wall, unknown, unknown);
    expect([...poolCells(cells, 4, 2, 2)]).toEqual([wall, free]);
  });

  it('may be fewer at the edge', () => {
    const cells = Uint8Array.of(free, free, wall, unknown, unknown, unknown);
    expect([...poolCells(cells, 3, 2, 2)]).toEqual([free, wall]);
  });

  it('are themselves when each has its own', () => {
    const cells = Uint8Array.of(free, wall, unknown, free);
    expect(poolCells(cells, 2, 2, 1)).toEqual(cells);
  });
});

describe('beams of a scan', () => {
  it('end where their angles and ranges say, and are left out where nothing was measured', () => {
    const values = Array.from({ length: 1081 }, (_, i) => 500 + ((i * 37) % 5000));
    values[3] = TOO_CLOSE;
    values[4] = BROKEN;
    values[5] = NOTHING;
    const scan = {
      baseFromLaser: { x: 0, y: 0, heading: 0 },
      angleMin: -2.356,
      angleIncrement: 0.00436,
      rangeMax: 8,
      unit: 0.001,
      ranges: Uint16Array.from(values),
    };
    const ends: { x: number; y: number; hit: boolean }[] = [];
    eachBeam(scan, (x, y, hit) => ends.push({ x, y, hit }));
    const wanted = values.flatMap((value, i) => {
      const angle = scan.angleMin + i * scan.angleIncrement;
      const range = value === NOTHING ? 8 : value * 0.001;
      return value === TOO_CLOSE || value === BROKEN
        ? []
        : [{ x: range * Math.cos(angle), y: range * Math.sin(angle), hit: value !== NOTHING }];
    });
    expect(ends.map(({ hit }) => hit)).toEqual(wanted.map(({ hit }) => hit));
    const off = ends.map(({ x, y }, i) => Math.hypot(x - wanted[i]!.x, y - wanted[i]!.y));
    expect(Math.max(...off)).toBeLessThan(1e-9);

    const laser = { x: 3, y: -2, heading: 2.5 };
    const onMap: Pose[] = [];
    eachBeam(scan, (x, y) => onMap.push({ x, y, heading: 0 }), laser);
    const apart = onMap.map(({ x, y }, i) => {
      const there = compose(laser, { ...ends[i]!, heading: 0 });
      return Math.hypot(x - there.x, y - there.y);
    });
    expect(apart).toHaveLength(ends.length);
    expect(Math.max(...apart)).toBeLessThan(1e-9);
  });
});

describe('dots', () => {
  it('are squares as strong as they should be, stronger where they lie upon each other, cut at the edge', () => {
    const drawn: ImageData[] = [];
    const image = class {
      data: Uint8ClampedArray;
      constructor(
        readonly width: number,
        readonly height: number,
      ) {
        this.data = new Uint8ClampedArray(4 * width * height);
      }
    };
    vi.stubGlobal('ImageData', image);
    vi.stubGlobal('document', {
      createElement: () => ({ getContext: () => ({ putImageData: (one: ImageData) => drawn.push(one) }) }),
    });
    const nothing = () => undefined;
    const context = {
      canvas: { width: 5, height: 4 },
      getTransform: () => ({ a: 1, b: 0, c: 0, d: -1, e: 0, f: 4 }), // a metre is a pixel, y up
      save: nothing,
      resetTransform: nothing,
      drawImage: nothing,
      restore: nothing,
    } as unknown as CanvasRenderingContext2D;
    const dots = new Dots();
    dots.begin(context, 2, 0.5);
    dots.set(1, 3, bgrOf('#102030'));
    dots.set(1, 3, bgrOf('#102030')); // the same again is one
    dots.set(2, 3, bgrOf('#405060'), 0.5);
    dots.set(5, 0, bgrOf('#405060'));
    dots.set(-9, 3, bgrOf('#405060'));
    dots.draw(context);
    const alphas = drawn[0]!.data.filter((_, i) => i % 4 === 3);
    expect([...alphas]).toEqual([128, 160, 64, 0, 0, 128, 160, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128]);
    expect([...drawn[0]!.data.slice(0, 7)]).toEqual([0x10, 0x20, 0x30, 128, 0x40, 0x50, 0x60]);
    vi.unstubAllGlobals();
  });
});
