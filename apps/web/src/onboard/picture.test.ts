import { describe, expect, it } from 'vitest';
import type { MapInfo } from '../api/messages';
import { Picture, type Colors, type Eye, type Prism, type Rgb, type Walls } from './picture';

const [WIDTH, HEIGHT] = [48, 36];
const FIELD_OF_VIEW = (90 * Math.PI) / 180;
const FOCAL = WIDTH / 2 / Math.tan(FIELD_OF_VIEW / 2);
const WALL: Rgb = [200, 0, 0];
const BOX: Rgb = [0, 200, 0];
const BALL: Rgb = [0, 0, 200];
const COLORS: Colors = {
  sky: [255, 255, 255],
  floor: [120, 120, 120],
  tile: [120, 120, 120],
  unknown: [60, 60, 60],
};

/** The same numbers each time. */
function randomly(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function mapOf(rows: string[]): { map: MapInfo; cells: Uint8Array } {
  const [width, height] = [rows[0]!.length, rows.length];
  const cells = new Uint8Array(width * height);
  rows.forEach((line, row) =>
    [...line].forEach((cell, column) => {
      cells[(height - 1 - row) * width + column] = cell === '#' ? 100 : cell === '?' ? 255 : 0;
    }),
  );
  const map = {
    name: '',
    width,
    height,
    resolution: 0.5,
    originX: -1,
    originY: -2,
    colors: [],
    wallHeight: null,
  };
  return { map, cells };
}

function turnedBox(x: number, y: number, side: number, heading: number): Float64Array {
  const corners = [0, 1, 2, 3].flatMap((quarter) => {
    const angle = heading + (Math.PI / 2) * quarter;
    return [x + side * Math.cos(angle), y + side * Math.sin(angle)];
  });
  return Float64Array.from(corners);
}

function contains({ outline, low, high }: Prism, x: number, y: number, z: number): boolean {
  let inside = false;
  for (let b = 0, a = outline.length - 2; b < outline.length; a = b, b += 2) {
    const [ax, ay, bx, by] = [outline[a]!, outline[a + 1]!, outline[b]!, outline[b + 1]!];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) {
      inside = !inside;
    }
  }
  return inside && z > low && z < high;
}

function cellOf({ map, cells }: Walls, x: number, y: number): number {
  const column = Math.floor((x - map.originX) / map.resolution);
  const row = Math.floor((y - map.originY) / map.resolution);
  const isInside = column >= 0 && row >= 0 && column < map.width && row < map.height;
  return isInside ? cells[row * map.width + column]! : 255;
}

type Seen = 'sky' | 'floor' | 'unknown' | 'wall' | 'box' | 'ball';

/** What a ray meets first, step by step. */
function march(column: number, row: number, { pose, z }: Eye, walls: Walls, prisms: Prism[]): Seen {
  const aside = (column + 0.5 - WIDTH / 2) / FOCAL;
  const rise = -(row + 0.5 - HEIGHT / 2) / FOCAL;
  const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  const cellAt = (x: number, y: number) => cellOf(walls, x, y);
  for (let depth = 0.021; depth < 30; depth += 0.004) {
    const x = pose.x + depth * (cos + aside * sin);
    const y = pose.y + depth * (sin - aside * cos);
    const height = z + depth * rise;
    if (height < 0) {
      return cellAt(x, y) === 255 ? 'unknown' : 'floor';
    }
    const hit = prisms.find((prism) => contains(prism, x, y, height));
    if (hit) {
      return hit.color === BOX ? 'box' : 'ball';
    }
    if (height < walls.height && cellAt(x, y) === 100) {
      return 'wall';
    }
  }
  return rise > 0 ? 'sky' : 'unknown';
}

function seenIn(picture: Picture, column: number, row: number): Seen {
  const [red, green, blue] = picture.pixels.subarray(4 * (row * WIDTH + column)) as unknown as number[];
  if (red === green && green === blue) {
    return red === 255 ? 'sky' : red === 120 ? 'floor' : 'unknown';
  }
  return red! > 0 ? 'wall' : green! > 0 ? 'box' : 'ball';
}

describe('what a robot would see', () => {
  const { map, cells } = mapOf([
    '################',
    '#......#.......#',
    '#......#.......#',
    '#..............#',
    '#..............#',
    '#.......###....#',
    '#..............#',
    '#..??..........#',
    '#..??..........#',
    '################',
  ]);
  const picture = new Picture(WIDTH, HEIGHT, FIELD_OF_VIEW);

  function wallsOf(height: number): Walls {
    return { map, cells, height, colors: new Map([[100, WALL]]) };
  }

  it.each([1, 2, 3, 4, 5, 6, 7, 8])('is what rays meet that go step by step (seed %i)', (seed) => {
    const random = randomly(seed);
    for (let scene = 0; scene < 6; scene++) {
      const walls = wallsOf(random() < 0.5 ? 1 : 0.3);
      const prisms: Prism[] = Array.from({ length: 4 }, (_, i) => {
        const low = random() < 0.5 ? 0 : 0.6 * random();
        const outline = turnedBox(7 * random(), 3 * random() - 1.5, 0.1 + 0.4 * random(), 6 * random());
        return { outline, low, high: low + 0.1 + random(), color: i % 2 === 0 ? BOX : BALL };
      });
      const pose = { x: 0.3 + 5 * random(), y: 2 * random() - 1, heading: 7 * random() - 3.5 };
      const eye = { pose, z: 0.2 + 0.6 * random() };
      const isBuried =
        cellOf(walls, pose.x, pose.y) === 100 ||
        prisms.some((prism) => contains({ ...prism, low: -1, high: 9 }, pose.x, pose.y, 0));
      if (isBuried) {
        continue;
      }
      picture.draw(eye, walls, prisms, COLORS);
      let wrong = 0;
      for (let i = 0; i < 300; i++) {
        const [column, row] = [Math.floor(WIDTH * random()), Math.floor(HEIGHT * random())];
        wrong += seenIn(picture, column, row) === march(column, row, eye, walls, prisms) ? 0 : 1;
      }
      expect(wrong, `scene ${scene}`).toBeLessThanOrEqual(6); // steps of 4 mm pass over edges
    }
  });

  it('hides what is behind a wall, and shows what is higher', () => {
    const walls = wallsOf(0.5);
    const eye = { pose: { x: 0, y: 2, heading: 0 }, z: 0.3 };
    const behind = { outline: turnedBox(4, 2, 0.2, 0), low: 0, color: BOX };
    const shows = (high: number) => {
      picture.draw(eye, walls, [{ ...behind, high }], COLORS);
      return Array.from({ length: HEIGHT }, (_, row) => seenIn(picture, WIDTH / 2, row)).includes('box');
    };
    expect(shows(0.4)).toBe(false);
    expect(shows(2)).toBe(true);
  });

  it('says where a place is, and whether it is hidden', () => {
    picture.draw({ pose: { x: 0, y: 2, heading: 0 }, z: 0.3 }, wallsOf(1), [], COLORS);
    const before = picture.project(1, 2, 0.3)!;
    expect(before.px).toBeCloseTo(WIDTH / 2);
    expect(before.py).toBeCloseTo(HEIGHT / 2);
    expect(before.depth).toBeCloseTo(1);
    expect(picture.isOpen(before.px, before.py, before.depth)).toBe(true);
    const behind = picture.project(5, 2, 0.3)!;
    expect(picture.isOpen(behind.px, behind.py, behind.depth)).toBe(false);
    expect(picture.project(-1, 2, 0.3)).toBeNull();
    const right = picture.project(1, 1.5, 0.3)!;
    expect(right.px).toBeGreaterThan(before.px);
  });

  it('sees out of a wall, and from outside of the map', () => {
    picture.draw({ pose: { x: 2.8, y: 2.2, heading: Math.PI }, z: 0.3 }, wallsOf(1), [], COLORS);
    expect(seenIn(picture, WIDTH / 2, HEIGHT - 1)).toBe('floor');
    picture.draw({ pose: { x: -5, y: 0, heading: 0 }, z: 0.3 }, wallsOf(1), [], COLORS);
    expect(seenIn(picture, WIDTH / 2, HEIGHT / 2)).toBe('wall');
  });
});
