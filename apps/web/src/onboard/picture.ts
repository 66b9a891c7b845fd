/**
 * What a robot would see: a picture by a level pinhole camera, drawn in plain numbers, as a machine without a GPU does
 * it fastest. Column by column, each surface that the column's ray meets is a strip, and a depth for each pixel keeps
 * the nearest: exact, in whatever order things come.
 *
 * The camera's axes: depth along its heading, aside to its right, z up [m]. A pixel at `aside / depth` from the middle,
 * times the focal length, and likewise for heights.
 */

import type { MapInfo } from '../api/messages';
import type { Pose } from '../live/frame';

/** Nearer than this nothing is seen [m]. */
const NEAR = 0.02;
/** Farther than this walls are not looked for [m]. */
const FAR = 200;
/** Side of the squares that the floor is tiled by, so that motion is seen [m]. */
const TILE = 1;
/** Beyond this tiles would be smaller than pixels, and flicker [m]. */
const TILES_END = 12;

const FREE = 0;
const UNKNOWN = 255;

/** Red, green and blue, 0 to 255. */
export type Rgb = readonly [number, number, number];

/** Something upright with a flat top: an outline in the map frame [m], x and y in turns, and its heights [m]. */
export interface Prism {
  outline: Float64Array;
  low: number;
  high: number;
  color: Rgb;
}

export interface Walls {
  map: MapInfo;
  cells: Uint8Array;
  /** Above the floor [m]. */
  height: number;
  /** By cell value. */
  colors: ReadonlyMap<number, Rgb>;
}

export interface Eye {
  pose: Pose;
  /** Above the floor [m]. */
  z: number;
}

export interface Colors {
  sky: Rgb;
  floor: Rgb;
  tile: Rgb;
  unknown: Rgb;
}

/** A picture of some size, to be drawn again and again. */
export class Picture {
  /** As ImageData has it: red, green, blue and alpha of each pixel, the upper row first. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  private readonly colors: Uint32Array;
  /** How far each pixel is, along the camera's axis [m]. */
  private readonly depths: Float32Array;
  private readonly focal: number;
  private eye: Eye = { pose: { x: 0, y: 0, heading: 0 }, z: 0 };
  private cos = 1;
  private sin = 0;

  /** @param fieldOfView from the left edge to the right one [rad], below π */
  constructor(
    readonly width: number,
    readonly height: number,
    fieldOfView: number,
  ) {
    const buffer = new ArrayBuffer(4 * width * height);
    this.pixels = new Uint8ClampedArray(buffer);
    this.colors = new Uint32Array(buffer);
    this.depths = new Float32Array(width * height);
    this.focal = width / 2 / Math.tan(fieldOfView / 2);
  }

  draw(eye: Eye, walls: Walls, prisms: readonly Prism[], colors: Colors) {
    this.eye = eye;
    this.cos = Math.cos(eye.pose.heading);
    this.sin = Math.sin(eye.pose.heading);
    this.drawGround(walls, colors);
    for (let column = 0; column < this.width; column++) {
      this.drawWalls(column, walls);
    }
    prisms.forEach((prism) => this.drawPrism(prism));
  }

  /** Where a place is in the picture [px] and how far; null of what is behind the camera. */
  project(x: number, y: number, z: number): { px: number; py: number; depth: number } | null {
    const [dx, dy] = [x - this.eye.pose.x, y - this.eye.pose.y];
    const depth = this.cos * dx + this.sin * dy;
    if (depth < NEAR) {
      return null;
    }
    const aside = this.sin * dx - this.cos * dy;
    return { px: this.width / 2 + (this.focal * aside) / depth, py: this.rowOf(z, depth), depth };
  }

  /** Whether what is at a pixel is farther away than this [m]. */
  isOpen(px: number, py: number, depth: number): boolean {
    const [column, row] = [Math.floor(px), Math.floor(py)];
    const isInside = column >= 0 && row >= 0 && column < this.width && row < this.height;
    return isInside && this.depths[row * this.width + column]! > depth;
  }

  private rowOf(z: number, depth: number): number {
    return this.height / 2 - (this.focal * (z - this.eye.z)) / depth;
  }

  /** The way of a column's ray in the map frame: this much for each metre of depth. */
  private ray(column: number): [number, number] {
    const aside = (column + 0.5 - this.width / 2) / this.focal;
    return [this.cos + aside * this.sin, this.sin - aside * this.cos];
  }

  private drawGround({ map, cells }: Walls, { sky, floor, tile, unknown }: Colors) {
    const { width, height, colors, depths, eye } = this;
    const [free, tiled, nowhere, above] = [packed(floor), packed(tile), packed(unknown), packed(sky)];
    const horizon = Math.min(height, Math.ceil(height / 2));
    const [firstX, firstY] = this.ray(0);
    colors.fill(above, 0, horizon * width);
    depths.fill(Infinity);
    for (let row = horizon; row < height; row++) {
      const depth = (this.focal * eye.z) / (row + 0.5 - height / 2);
      const [nextX, nextY] = [(depth * this.sin) / this.focal, (-depth * this.cos) / this.focal];
      let x = eye.pose.x + depth * firstX;
      let y = eye.pose.y + depth * firstY;
      const isTiled = depth < TILES_END;
      for (let at = row * width; at < (row + 1) * width; at++, x += nextX, y += nextY) {
        const column = Math.floor((x - map.originX) / map.resolution);
        const line = Math.floor((y - map.originY) / map.resolution);
        const isOnMap = column >= 0 && line >= 0 && column < map.width && line < map.height;
        const isKnown = isOnMap && cells[line * map.width + column] !== UNKNOWN;
        const isOdd = ((Math.floor(x / TILE) + Math.floor(y / TILE)) & 1) === 1;
        colors[at] = isKnown ? (isTiled && isOdd ? tiled : free) : nowhere;
        depths[at] = depth;
      }
    }
  }

  /** Goes from cell to cell along a column's ray (J. Amanatides, A. Woo: A Fast Voxel Traversal Algorithm, 1987). */
  private drawWalls(column: number, { map, cells, height, colors }: Walls) {
    const { resolution } = map;
    const [dx, dy] = this.ray(column);
    const fromX = (this.eye.pose.x - map.originX) / resolution;
    const fromY = (this.eye.pose.y - map.originY) / resolution;
    let [cellX, cellY] = [Math.floor(fromX), Math.floor(fromY)];
    const [stepX, stepY] = [dx > 0 ? 1 : -1, dy > 0 ? 1 : -1];
    const [acrossX, acrossY] = [Math.abs(resolution / dx), Math.abs(resolution / dy)];
    let nextX = dx === 0 ? Infinity : acrossX * (dx > 0 ? cellX + 1 - fromX : fromX - cellX);
    let nextY = dy === 0 ? Infinity : acrossY * (dy > 0 ? cellY + 1 - fromY : fromY - cellY);
    let wall = FREE; // value of the cells that the ray is in
    let began = 0; // depth at which it came into them
    let depth = 0;
    let isBuried = isWallAt(map, cells, cellX, cellY); // whoever stands in a wall sees out of it
    while (depth < FAR) {
      const alongX = nextX < nextY;
      if (alongX) {
        depth = nextX;
        nextX += acrossX;
        cellX += stepX;
      } else {
        depth = nextY;
        nextY += acrossY;
        cellY += stepY;
      }
      if ((stepX > 0 ? cellX >= map.width : cellX < 0) || (stepY > 0 ? cellY >= map.height : cellY < 0)) {
        break; // it never comes back to the map
      }
      const isWall = isWallAt(map, cells, cellX, cellY);
      const value = isWall ? cells[cellY * map.width + cellX]! : FREE;
      if (isBuried && isWall) {
        continue;
      }
      isBuried = false;
      if (wall !== FREE && value !== wall) {
        this.drawLevel(column, began, depth, height, lit(colors.get(wall)!, 1));
        wall = FREE;
      }
      if (isWall && wall === FREE) {
        const light = alongX ? lightOf(-stepX, 0) : lightOf(0, -stepY);
        this.drawStrip(column, depth, 0, height, lit(colors.get(value)!, light));
        if (this.eye.z <= height) {
          return; // it hides all walls behind it
        }
        wall = value;
        began = depth;
      }
    }
    if (wall !== FREE) {
      this.drawLevel(column, began, depth, height, lit(colors.get(wall)!, 1));
    }
  }

  private drawPrism({ outline, low, high, color }: Prism) {
    const [first, last] = this.columnsOf(outline);
    const corners = outline.length;
    const top = lit(color, 1);
    const bottom = lit(color, 0.5);
    for (let column = first; column <= last; column++) {
      const [dx, dy] = this.ray(column);
      const crossings: number[] = [];
      for (let b = 0, a = corners - 2; b < corners; a = b, b += 2) {
        const [ax, ay] = [outline[a]! - this.eye.pose.x, outline[a + 1]! - this.eye.pose.y];
        const [ex, ey] = [outline[b]! - outline[a]!, outline[b + 1]! - outline[a + 1]!];
        const isLeft = ax * dy < ay * dx;
        const [bx, by] = [ax + ex, ay + ey];
        if (isLeft === bx * dy < by * dx) {
          continue; // both ends are on one side of the ray
        }
        const turn = dx * ey - dy * ex;
        const depth = (ax * ey - ay * ex) / turn;
        crossings.push(depth);
        if (depth > NEAR) {
          const length = Math.hypot(ex, ey);
          const out = turn > 0 ? 1 : -1; // the side that is seen looks at the camera
          this.drawStrip(
            column,
            depth,
            low,
            high,
            lit(color, lightOf((-out * ey) / length, (out * ex) / length)),
          );
        }
      }
      crossings.sort((one, other) => one - other);
      for (let i = 0; i + 1 < crossings.length; i += 2) {
        const [from, to] = [Math.max(NEAR, crossings[i]!), crossings[i + 1]!];
        if (to > from) {
          this.drawLevel(column, from, to, high, top);
          this.drawLevel(column, from, to, low, bottom);
        }
      }
    }
  }

  /** Between which columns an outline is; all when some of it is beside or behind the camera. */
  private columnsOf(outline: Float64Array): [number, number] {
    let [least, most] = [Infinity, -Infinity];
    let behind = 0;
    for (let at = 0; at < outline.length; at += 2) {
      const place = this.project(outline[at]!, outline[at + 1]!, 0);
      if (place) {
        least = Math.min(least, place.px);
        most = Math.max(most, place.px);
      } else {
        behind++;
      }
    }
    if (2 * behind === outline.length) {
      return [0, -1];
    }
    return behind > 0
      ? [0, this.width - 1]
      : [Math.max(0, Math.floor(least) - 1), Math.min(this.width - 1, Math.ceil(most) + 1)];
  }

  /** An upright surface. */
  private drawStrip(column: number, far: number, low: number, high: number, color: number) {
    const depth = Math.max(NEAR, far);
    const first = Math.max(0, Math.ceil(this.rowOf(high, depth) - 0.5));
    const end = Math.min(this.height, Math.ceil(this.rowOf(low, depth) - 0.5));
    for (let row = first, at = first * this.width + column; row < end; row++, at += this.width) {
      if (depth < this.depths[at]!) {
        this.depths[at] = depth;
        this.colors[at] = color;
      }
    }
  }

  /** A level surface, seen from above or below. */
  private drawLevel(column: number, from: number, to: number, z: number, color: number) {
    const rise = z - this.eye.z;
    if (rise === 0) {
      return;
    }
    const near = this.rowOf(z, Math.max(NEAR, from));
    const far = this.rowOf(z, to);
    const first = Math.max(0, Math.ceil(Math.min(near, far) - 0.5));
    const end = Math.min(this.height, Math.ceil(Math.max(near, far) - 0.5));
    for (let row = first, at = first * this.width + column; row < end; row++, at += this.width) {
      const depth = (-rise * this.focal) / (row + 0.5 - this.height / 2);
      if (depth < this.depths[at]!) {
        this.depths[at] = depth;
        this.colors[at] = color;
      }
    }
  }
}

function isWallAt({ width, height }: MapInfo, cells: Uint8Array, column: number, row: number): boolean {
  const isInside = column >= 0 && row >= 0 && column < width && row < height;
  const value = isInside ? cells[row * width + column]! : FREE;
  return value !== FREE && value !== UNKNOWN;
}

/** How light an upright side is that looks this way: the light comes from the south-west, half above. */
function lightOf(nx: number, ny: number): number {
  return 0.78 - 0.09 * nx - 0.05 * ny;
}

function lit([red, green, blue]: Rgb, light: number): number {
  return packed([light * red, light * green, light * blue]);
}

/** As the bytes of a pixel are read at once, the least first. */
function packed([red, green, blue]: Rgb): number {
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}
