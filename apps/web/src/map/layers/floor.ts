import type { MapInfo } from '../../api/messages';
import { toOklab } from '../../shades';
import { rgb, type Palette } from '../palette';
import type { View } from '../view';

const FREE = 0;
const OCCUPIED = 100; // and colored walls up from there
/** Walls of at least this much color (chroma, of OKLab) keep it. */
const COLORFUL = 0.05;
const UNKNOWN = 255;

type Rgba = [number, number, number, number];
const NOTHING: Rgba = [0, 0, 0, 0];

/** A picture of a map; of a map seen from afar, one pixel is `pool` × `pool` cells. */
export interface Floor {
  picture: OffscreenCanvas;
  map: MapInfo;
  pool: number;
}

/** How many cells of a map share a pixel. */
export function poolOf(map: MapInfo, view: View): number {
  return Math.max(1, Math.floor(1 / (map.resolution * view.scale)));
}

/** Whether walls keep a color; else they have that of walls, which is seen on light and dark floors. */
export function isColorful(color: string): boolean {
  const [, a, b] = toOklab(color);
  return Math.hypot(a, b) >= COLORFUL;
}

/** Pictures a map, upper row first. */
export function paintFloor(map: MapInfo, cells: Uint8Array, pool: number, palette: Palette): Floor {
  const colors = opaque(wallColors(map, palette.occupied));
  colors.set(FREE, [...rgb(palette.free), 255]);
  colors.set(UNKNOWN, [...rgb(palette.unknown), 255]);
  return paint(map, cells, pool, colors);
}

/**
 * Pictures the walls of a map alone.
 *
 * @param plain of those that keep no color
 */
export function paintWalls(map: MapInfo, cells: Uint8Array, pool: number, plain: string): Floor {
  return paint(map, cells, pool, opaque(wallColors(map, plain)).set(FREE, NOTHING).set(UNKNOWN, NOTHING));
}

/** Whether a cell of a map is solid. */
export function isWall(value: number): boolean {
  return value !== FREE && value !== UNKNOWN;
}

function opaque(colors: ReadonlyMap<number, string>): Map<number, Rgba> {
  return new Map([...colors].map(([value, color]) => [value, [...rgb(color), 255]]));
}

/**
 * Colors of walls, by cell value.
 *
 * @param plain of those that keep none
 */
export function wallColors(map: MapInfo, plain: string): Map<number, string> {
  const colors = new Map([[OCCUPIED, plain]]);
  map.colors.forEach((color, i) => colors.set(OCCUPIED + 1 + i, isColorful(color) ? color : plain));
  return colors;
}

/** Pictures a map that a robot has drawn, to be seen through. */
export function paintDrawn(map: MapInfo, cells: Uint8Array, pool: number, palette: Palette): Floor {
  const colors = new Map<number, Rgba>([
    [FREE, [...rgb(palette.drawn), 110]],
    [OCCUPIED, [...rgb(palette.drawnWall), 255]],
    [UNKNOWN, NOTHING],
  ]);
  return paint(map, cells, pool, colors);
}

/** Pictures what places cost, to be seen through: the dearer the stronger. */
export function paintCosts(map: MapInfo, cells: Uint8Array, pool: number, palette: Palette): Floor {
  const [dear, blocked] = [rgb(palette.dear), rgb(palette.blocked)];
  const colors = new Map<number, Rgba>([
    [FREE, NOTHING],
    [OCCUPIED, [...blocked, 72]],
    [UNKNOWN, NOTHING],
  ]);
  for (let cost = FREE + 1; cost < OCCUPIED; cost++) {
    colors.set(cost, [...dear, 10 + 1.3 * cost]);
  }
  return paint(map, cells, pool, colors);
}

function paint(map: MapInfo, cells: Uint8Array, pool: number, colors: Map<number, Rgba>): Floor {
  const pooled = poolCells(cells, map.width, map.height, pool);
  const width = Math.ceil(map.width / pool);
  const height = Math.ceil(map.height / pool);
  const picture = new OffscreenCanvas(width, height);
  const context = picture.getContext('2d')!;
  const image = context.createImageData(width, height);
  for (let row = 0; row < height; row++) {
    let to = 4 * (height - 1 - row) * width;
    for (let column = 0; column < width; column++, to += 4) {
      image.data.set(colors.get(pooled[row * width + column]!)!, to);
    }
  }
  context.putImageData(image, 0, 0);
  return { picture, map, pool };
}

/**
 * Makes one cell of `pool` × `pool`. A wall wins over all else, and free over unknown, so that walls that are
 * thinner than a pixel are still seen.
 */
export function poolCells(cells: Uint8Array, width: number, height: number, pool: number): Uint8Array {
  const columns = Math.ceil(width / pool);
  const pooled = new Uint8Array(columns * Math.ceil(height / pool)).fill(UNKNOWN);
  for (let row = 0; row < height; row++) {
    const start = Math.floor(row / pool) * columns;
    for (let column = 0; column < width; column++) {
      const value = cells[row * width + column]!;
      const to = start + Math.floor(column / pool);
      if (value !== FREE && value !== UNKNOWN) {
        pooled[to] = value;
      } else if (value === FREE && pooled[to] === UNKNOWN) {
        pooled[to] = FREE;
      }
    }
  }
  return pooled;
}

/**
 * Draws a floor in canvas coordinates.
 *
 * @param z how high above the floor it is [m]
 */
export function drawFloor(
  context: CanvasRenderingContext2D,
  { picture, map, pool }: Floor,
  view: View,
  z = 0,
) {
  const pixel = pool * map.resolution;
  context.save();
  context.imageSmoothingEnabled = pixel * view.scale < 3 || view.turn !== 0 || view.oblique; // close up, cells are cells
  context.imageSmoothingQuality = pixel * view.scale < 3 ? 'high' : 'low';
  view.enter(context);
  context.translate(map.originX + z * view.up.x, map.originY + z * view.up.y);
  context.scale(pixel, -pixel); // rows of pictures go down
  context.drawImage(picture, 0, -picture.height);
  context.restore();
}
