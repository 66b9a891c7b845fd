import type { MapInfo } from '../../api/messages';
import { shaded } from '../palette';
import type { Point, View } from '../view';
import { isWall, poolCells } from './floor';

const FREE = 0;

/** Sides are painted in bands of this depth, the farthest first [m]. */
const BAND = 0.25;
/** Bands overlap by this part of one, so that no line is seen between them. */
const SEAM = 0.2;

/** Where walls look to, as x and y of the way out of them. */
const FACINGS = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
] as const;

/** Sides of walls that look one way, four numbers each: from x, y to x, y [m]; and the cell value of each. */
interface Sides {
  facing: readonly [number, number];
  ends: number[];
  values: number[];
}

/** Sides of a map's walls, those in a row as one. */
export function sidesOf(map: MapInfo, cells: Uint8Array, pool: number): Sides[] {
  const pooled = poolCells(cells, map.width, map.height, pool);
  const columns = Math.ceil(map.width / pool);
  const rows = Math.ceil(map.height / pool);
  const side = pool * map.resolution;
  return FACINGS.map((facing) => {
    const [dx, dy] = facing;
    const sides: Sides = { facing, ends: [], values: [] };
    const lies = dx === 0; // along the x axis
    const [lines, length] = lies ? [rows, columns] : [columns, rows];
    const [lineStep, step] = lies ? [columns, 1] : [1, columns];
    const out = dx + dy * columns;
    for (let line = 0; line < lines; line++) {
      const isEdge = line + dx + dy < 0 || line + dx + dy >= lines;
      const across = line + (dx + dy > 0 ? 1 : 0);
      let begun = 0;
      let value = FREE;
      for (let along = 0, cell = line * lineStep; along <= length; along++, cell += step) {
        const here = along < length ? pooled[cell]! : FREE;
        const next = isWall(here) && (isEdge || !isWall(pooled[cell + out]!)) ? here : FREE;
        if (next === value) {
          continue;
        }
        if (value !== FREE) {
          const ends = lies ? [begun, across, along, across] : [across, begun, across, along];
          ends.forEach((at, i) => sides.ends.push((i % 2 === 0 ? map.originX : map.originY) + at * side));
          sides.values.push(value);
        }
        begun = along;
        value = next;
      }
    }
    return sides;
  });
}

/** What of walls is seen from one side, in map coordinates. */
export type Relief = {
  color: string;
  path: Path2D;
  /** How deep in the picture the nearest of it is, on the floor, from the map's origin [m]. */
  depth: number;
}[];

/**
 * Sides of walls that are seen, the farthest first: those in a band of depth and of one color are one path, so that a
 * large map is a few hundred. Tops are not among them; they are the map's picture, raised, and hide sides behind them.
 *
 * @param up where a metre of height is drawn on the floor
 * @param colors by cell value
 * @param high how high walls are [m]
 */
export function reliefOf(
  all: readonly Sides[],
  up: Point,
  colors: ReadonlyMap<number, string>,
  high: number,
): Relief {
  const away = Math.hypot(up.x, up.y);
  const bands = new Map<number, Map<string, Path2D>>();
  const [hx, hy] = [high * up.x, high * up.y];
  for (const { facing, ends, values } of all) {
    const [nx, ny] = facing;
    if (nx * up.x + ny * up.y > -1e-9) {
      continue; // it looks away
    }
    const light = lightOf(nx, ny, up);
    for (let i = 0; i < values.length; i++) {
      const [ax, ay, bx, by] = [ends[4 * i]!, ends[4 * i + 1]!, ends[4 * i + 2]!, ends[4 * i + 3]!];
      const color = shaded(colors.get(values[i]!)!, light);
      const depth = ((bx - ax) * up.x + (by - ay) * up.y) / away;
      const parts = Math.max(1, Math.ceil(Math.abs(depth) / BAND));
      for (let part = 0; part < parts; part++) {
        const [from, to] = [part / parts, Math.min(1, (part + 1 + SEAM) / parts)];
        const [x0, y0] = [ax + from * (bx - ax), ay + from * (by - ay)];
        const [x1, y1] = [ax + to * (bx - ax), ay + to * (by - ay)];
        const band = Math.floor(((x0 + x1) * up.x + (y0 + y1) * up.y) / (2 * away * BAND));
        const path = pathIn(bands, band, color);
        path.moveTo(x0, y0);
        path.lineTo(x1, y1);
        path.lineTo(x1 + hx, y1 + hy);
        path.lineTo(x0 + hx, y0 + hy);
        path.closePath();
      }
    }
  }
  return [...bands.keys()]
    .sort((a, b) => b - a)
    .flatMap((band) => [...bands.get(band)!].map(([color, path]) => ({ color, path, depth: band * BAND })));
}

function pathIn(bands: Map<number, Map<string, Path2D>>, band: number, color: string): Path2D {
  let colors = bands.get(band);
  if (!colors) {
    colors = new Map();
    bands.set(band, colors);
  }
  let path = colors.get(color);
  if (!path) {
    path = new Path2D();
    colors.set(color, path);
  }
  return path;
}

/**
 * How light an upright side is, of what a top is: the light comes from the left.
 *
 * @param nx the way out of it, of length 1
 */
export function lightOf(nx: number, ny: number, up: Point): number {
  const right = (nx * up.y - ny * up.x) / Math.hypot(up.x, up.y);
  return 0.74 - 0.12 * right;
}

/**
 * Draws what of it is on a canvas of a height [px], in canvas coordinates.
 *
 * @param high how high walls are [m]
 */
export function drawRelief(
  context: CanvasRenderingContext2D,
  relief: Relief,
  view: View,
  height: number,
  high: number,
) {
  context.save();
  view.enter(context);
  for (const { color, path, depth } of relief) {
    const lower = view.originY - view.scale * view.squeeze * (depth - BAND);
    const upper = lower - view.scale * (view.squeeze * 3 * BAND + view.rise * high);
    if (lower > 0 && upper < height) {
      context.fillStyle = color;
      context.fill(path);
    }
  }
  context.restore();
}
