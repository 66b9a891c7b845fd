import type { MapInfo, PieceInfo } from '../../api/messages';
import type { Pose } from '../../live/frame';
import type { Thing } from '../../live/things';
import type { Palette } from '../palette';
import type { Point, View } from '../view';
import { drawBody } from './bodies';
import { isColorful } from './floor';
import { wallHeight } from './heights';

/** Side of the squares that what stands is found by [m]. */
const SQUARE = 2;
/** Corners of a disc's outline. */
const ROUND = 12;
const ORIGIN: Pose = { x: 0, y: 0, heading: 0 };

/** Something that stands still and may hide what is behind it. */
export interface Upright {
  pose: Pose;
  pieces: PieceInfo[];
  /** Of its underside above the floor [m]. */
  height: number;
  /** Of its top, likewise. */
  top: number;
  /** x and y of its corners in the map frame [m]. */
  outline: Float64Array;
}

/** Finds what hides whom in an oblique view. Made once for a map and what stands on it. */
export class Uprights {
  private readonly squares = new Map<string, number[]>();
  private readonly visited: Int32Array;
  private visit = 0;
  private readonly highest: number;

  constructor(private readonly all: readonly Upright[]) {
    this.visited = new Int32Array(all.length);
    this.highest = all.reduce((most, { top }) => Math.max(most, top), 0);
    all.forEach(({ outline }, i) => {
      let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
      for (let at = 0; at < outline.length; at += 2) {
        minX = Math.min(minX, outline[at]!);
        maxX = Math.max(maxX, outline[at]!);
        minY = Math.min(minY, outline[at + 1]!);
        maxY = Math.max(maxY, outline[at + 1]!);
      }
      for (let x = square(minX); x <= square(maxX); x++) {
        for (let y = square(minY); y <= square(maxY); y++) {
          const key = `${x},${y}`;
          const there = this.squares.get(key);
          if (there) {
            there.push(i);
          } else {
            this.squares.set(key, [i]);
          }
        }
      }
    });
  }

  /**
   * Draws again, over what stands at a place, what hides some of it.
   *
   * @param reach how far it reaches around the place [m]
   * @param top how high it reaches [m]
   */
  drawBefore(
    context: CanvasRenderingContext2D,
    place: Point,
    reach: number,
    top: number,
    view: View,
    palette: Palette,
  ) {
    const hiding = this.before(place, reach, view.up);
    if (hiding.length === 0) {
      return;
    }
    context.save();
    view.leave(context);
    const { px, py } = view.toPixel(place);
    const [across, above] = [
      reach * view.scale + 3,
      (reach * view.squeeze + top * view.rise) * view.scale + 3,
    ];
    context.beginPath();
    context.rect(px - across, py - above, 2 * across, above + reach * view.squeeze * view.scale + 3);
    context.clip();
    view.enter(context);
    for (const { pose, pieces, height } of hiding) {
      const ink = { color: palette.standing, line: palette.edge, lineWidth: 0 };
      drawBody(context, view.raised(pose, height), pieces, ink, view);
    }
    context.restore();
  }

  /** What hides something at a place, the farthest first. */
  before(place: Point, reach: number, up: Point): Upright[] {
    const steep = Math.hypot(up.x, up.y);
    if (steep === 0) {
      return [];
    }
    const [ux, uy] = [up.x / steep, up.y / steep];
    const length = this.highest * steep + reach;
    const [endX, endY] = [place.x - length * ux, place.y - length * uy];
    const found: [number, Upright][] = [];
    this.visit++;
    for (let x = square(Math.min(place.x, endX) - reach); x <= square(Math.max(place.x, endX) + reach); x++) {
      for (
        let y = square(Math.min(place.y, endY) - reach);
        y <= square(Math.max(place.y, endY) + reach);
        y++
      ) {
        for (const i of this.squares.get(`${x},${y}`) ?? []) {
          if (this.visited[i] !== this.visit) {
            this.visited[i] = this.visit;
            const depth = depthBefore(this.all[i]!, place, reach, ux, uy, steep);
            if (depth !== null) {
              found.push([depth, this.all[i]!]);
            }
          }
        }
      }
    }
    return found.sort(([a], [b]) => b - a).map(([, upright]) => upright);
  }
}

function square(meters: number): number {
  return Math.floor(meters / SQUARE);
}

/**
 * How deep in the picture something is, from a place away from who looks [m], as far as it is beside the place by no
 * more than the reach; `null` when it hides nothing there.
 */
function depthBefore(
  { outline, top }: Upright,
  place: Point,
  reach: number,
  ux: number,
  uy: number,
  steep: number,
): number | null {
  let nearest = Infinity;
  let farthest = -Infinity;
  const corners = outline.length;
  for (let b = 0, a = corners - 2; b < corners; a = b, b += 2) {
    const [ax, ay] = [outline[a]! - place.x, outline[a + 1]! - place.y];
    const [bx, by] = [outline[b]! - place.x, outline[b + 1]! - place.y];
    const [aside, bside] = [ax * uy - ay * ux, bx * uy - by * ux];
    if (Math.min(aside, bside) > reach || Math.max(aside, bside) < -reach) {
      continue;
    }
    const [adeep, bdeep] = [ax * ux + ay * uy, bx * ux + by * uy];
    for (const end of [aside, bside]) {
      const clipped = Math.min(reach, Math.max(-reach, end));
      const share = bside === aside ? (end === aside ? 0 : 1) : (clipped - aside) / (bside - aside);
      const deep = adeep + share * (bdeep - adeep);
      nearest = Math.min(nearest, deep);
      farthest = Math.max(farthest, deep);
    }
    if (aside === bside) {
      nearest = Math.min(nearest, bdeep);
      farthest = Math.max(farthest, bdeep);
    }
  }
  const middle = (nearest + farthest) / 2;
  return middle < 0 && farthest + top * steep > -reach ? middle : null;
}

/** What stands somewhere on its pieces: a thing, or a robot. */
export interface Standing extends Pick<Thing, 'pose' | 'height'> {
  pieces: readonly PieceInfo[];
}

/** A piece of a thing, or all of one, in the map frame. */
export function uprightsOf({ pose, pieces, height }: Standing): Upright[] {
  const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  return pieces.map((piece) => {
    const corners =
      piece.radius > 0
        ? Array.from({ length: ROUND }, (_, i) => {
            const angle = (2 * Math.PI * i) / ROUND;
            const [x, y] = piece.corners[0] as [number, number];
            return [x + piece.radius * Math.cos(angle), y + piece.radius * Math.sin(angle)];
          })
        : piece.corners;
    const outline = new Float64Array(2 * corners.length);
    corners.forEach(([x, y], i) => {
      outline[2 * i] = pose.x + cos * x! - sin * y!;
      outline[2 * i + 1] = pose.y + sin * x! + cos * y!;
    });
    return { pose, pieces: [piece], height, top: height + piece.high, outline };
  });
}

/** Walls of a map as few rectangles: rows of cells, those that lie upon each other as one. */
export function wallsOf(map: MapInfo, cells: Uint8Array): Upright[] {
  const { width, height, resolution, originX, originY } = map;
  const high = wallHeight(map);
  const found: Upright[] = [];
  let open = new Map<string, { from: number; to: number; value: number; row: number }>();
  const close = (
    { from, to, value, row }: { from: number; to: number; value: number; row: number },
    end: number,
  ) => {
    const [left, right] = [originX + from * resolution, originX + to * resolution];
    const [bottom, top] = [originY + row * resolution, originY + end * resolution];
    const corners = [
      [left, bottom],
      [right, bottom],
      [right, top],
      [left, top],
    ];
    const own = map.colors[value - 101];
    const color = own !== undefined && isColorful(own) ? own : null;
    found.push({
      pose: ORIGIN,
      pieces: [{ color, corners, radius: 0, low: 0, high }],
      height: 0,
      top: high,
      outline: Float64Array.from(corners.flat()),
    });
  };
  for (let row = 0; row <= height; row++) {
    const next: typeof open = new Map();
    for (let column = 0; row < height && column < width;) {
      const value = cells[row * width + column]!;
      const from = column++;
      if (value === 0 || value === 255) {
        continue;
      }
      while (column < width && cells[row * width + column] === value) {
        column++;
      }
      const key = `${from},${column},${value}`;
      next.set(key, open.get(key) ?? { from, to: column, value, row });
      open.delete(key);
    }
    open.forEach((rectangle) => close(rectangle, row));
    open = next;
  }
  return found;
}
