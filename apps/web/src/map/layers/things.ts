import type { MapInfo, PieceInfo } from '../../api/messages';
import type { MovedThing, Pose } from '../../live/frame';
import { covers, isHandy, type Thing, type Things } from '../../live/things';
import type { Palette } from '../palette';
import type { Layer, Scene } from '../scene';
import type { Pixel, Point, View } from '../view';
import { areaOf, drawBody, traceBody } from './bodies';
import { drawFloor, isColorful, isWall, type Floor } from './floor';
import { FLAT, wallHeight } from './heights';
import { drawHandle, handleAhead } from './robots';
import { uprightsOf, type Upright, type Uprights } from './uprights';

/** What begins as high above the floor hides robots under it [m]; it is drawn over them, to be seen through. */
const OVERHEAD = 0.6;

function low({ pieces, height }: Thing): number {
  return height + Math.min(...pieces.map((piece) => piece.low));
}

export function top({ pieces, height }: Thing): number {
  return height + Math.max(...pieces.map((piece) => piece.high));
}

function isOverhead(thing: Thing): boolean {
  return low(thing) >= OVERHEAD;
}

/** As a frame has it. */
function movedTo(thing: Thing, moved: MovedThing): Thing {
  return { ...thing, pose: moved.pose, height: moved.height };
}

const walls = new WeakMap<Thing, Thing>();

/** A thing that others stand in, without the colors that walls of floor plans don't keep, either. */
function asWall(thing: Thing): Thing {
  let wall = walls.get(thing);
  if (!wall) {
    const pieces = thing.pieces.map((piece) =>
      piece.color !== null && !isColorful(piece.color) ? { ...piece, color: null } : piece,
    );
    wall = { ...thing, pieces };
    walls.set(thing, wall);
  }
  return wall;
}

const sorted = new WeakMap<Things, Thing[]>();

/** All things, the lowest first. */
function byHeight(things: Things): Thing[] {
  let all = sorted.get(things);
  if (!all) {
    all = [...things.all.values()].sort((a, b) => top(a) - top(b));
    sorted.set(things, all);
  }
  return all;
}

/** By the cells of a map, things that were looked for in its walls. */
const inWalls = new WeakMap<Uint8Array, WeakMap<Thing, boolean>>();

/** Whether something of a thing is where a map has walls. */
function isInWalls(thing: Thing, map: MapInfo, cells: Uint8Array): boolean {
  let known = inWalls.get(cells);
  if (!known) {
    known = new WeakMap();
    inWalls.set(cells, known);
  }
  let is = known.get(thing);
  if (is === undefined) {
    is = meetsWalls(thing, map, cells);
    known.set(thing, is);
  }
  return is;
}

function meetsWalls(thing: Thing, map: MapInfo, cells: Uint8Array): boolean {
  const { pose, reach } = thing;
  const { width, height, resolution, originX, originY } = map;
  const column = (x: number) => Math.min(width - 1, Math.max(0, Math.floor((x - originX) / resolution)));
  const row = (y: number) => Math.min(height - 1, Math.max(0, Math.floor((y - originY) / resolution)));
  const [left, right] = [column(pose.x - reach), column(pose.x + reach)];
  for (let j = row(pose.y - reach); j <= row(pose.y + reach); j++) {
    for (let i = left; i <= right; i++) {
      if (isWall(cells[j * width + i]!)) {
        const middle = { x: originX + (i + 0.5) * resolution, y: originY + (j + 0.5) * resolution };
        if (covers(thing, pose, middle, resolution / 2)) {
          return true;
        }
      }
    }
  }
  return false;
}

/** Numbers of things, and more numbers. */
export const numbersOf = (things: readonly Thing[], more: Iterable<number>): ReadonlySet<number> =>
  new Set([...more, ...things.map(({ number }) => number)]);

/**
 * Things that walls are drawn over, the lowest first: those that are lower and reach into them; and in an oblique view
 * all that are lower and that others stand in.
 *
 * @param moved numbers of those that are not where they were told to be
 */
export function thingsUnderWalls(
  things: Things,
  moved: ReadonlySet<number>,
  map: MapInfo,
  cells: Uint8Array,
  oblique: boolean,
  worldSide: number,
): Thing[] {
  const high = wallHeight(map);
  return byHeight(things).filter(
    (thing) =>
      top(thing) < high &&
      !isOverhead(thing) &&
      !moved.has(thing.number) &&
      ((oblique && !isHandy(thing, worldSide)) || isInWalls(thing, map, cells)),
  );
}

/** Draws them, in canvas coordinates. */
export function drawThingsUnderWalls(
  context: CanvasRenderingContext2D,
  under: readonly Thing[],
  view: View,
  palette: Palette,
  worldSide: number,
) {
  context.save();
  view.enter(context);
  for (const thing of under) {
    drawThing(context, isHandy(thing, worldSide) ? thing : asWall(thing), view, palette);
  }
  context.restore();
}

/** Draws walls over things that are lower, as seen from above: there alone, for all else lies over the map. */
export function drawWallsOver(
  context: CanvasRenderingContext2D,
  under: readonly Thing[],
  walls: Floor,
  view: View,
) {
  context.save();
  view.enter(context);
  context.clip(areaOf(under));
  view.leave(context);
  drawFloor(context, walls, view);
  context.restore();
}

/**
 * Draws those things that are where they were told to be, which are most. In canvas coordinates.
 *
 * @param left numbers of those that are not, and of those that are drawn already
 * @param walls what may hide some of them; of walls, when the view is oblique
 */
export function drawStillThings(
  context: CanvasRenderingContext2D,
  things: Things,
  left: ReadonlySet<number>,
  view: View,
  palette: Palette,
  width: number,
  height: number,
  worldSide: number,
  walls: Uprights | null,
) {
  context.save();
  view.enter(context);
  const still = (view.oblique ? byDepth(things, view.up) : byHeight(things)).filter((thing) => {
    const { px, py } = view.toPixel(thing.pose);
    const reach = thing.reach * view.scale;
    const above = top(thing) * view.rise * view.scale;
    const isSeen = px > -reach && px < width + reach && py > -reach && py - above < height + reach;
    return isSeen && !left.has(thing.number) && !isOverhead(thing);
  });
  if (walls === null) {
    for (const thing of still) {
      drawThing(context, isHandy(thing, worldSide) ? thing : asWall(thing), view, palette);
    }
  } else {
    const large = still.filter((thing) => !isHandy(thing, worldSide));
    for (const { piece, thing } of piecesByDepth(large, view.up)) {
      drawThing(context, { ...thing, pieces: [piece] }, view, palette);
    }
    for (const thing of still.filter((other) => isHandy(other, worldSide))) {
      drawThing(context, thing, view, palette);
      walls.drawBefore(context, thing.pose, thing.reach, top(thing), view, palette);
    }
  }
  context.restore();
}

/** Of a place that is farther away from who looks, more [m]. */
function depthOf({ x, y }: Point, up: Point): number {
  return x * up.x + y * up.y;
}

/** All things, the farthest first. */
function byDepth(things: Things, up: Point): Thing[] {
  return [...things.all.values()].sort(
    (a, b) => depthOf(b.pose, up) - depthOf(a.pose, up) || top(a) - top(b),
  );
}

/** Pieces of things that others stand in: each by itself, since they may stand around the others. */
function piecesByDepth(things: readonly Thing[], up: Point): { piece: PieceInfo; thing: Thing }[] {
  return things
    .flatMap((thing) =>
      asWall(thing).pieces.map((piece) => ({ piece, thing, depth: depthIn(thing.pose, piece, up) })),
    )
    .sort((a, b) => b.depth - a.depth);
}

function depthIn({ x, y, heading }: Pose, { corners }: PieceInfo, up: Point): number {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  const sum = corners.reduce(
    (total, [cx, cy]) => total + depthOf({ x: x + cos * cx! - sin * cy!, y: y + sin * cx! + cos * cy! }, up),
    0,
  );
  return sum / corners.length;
}

/** What stands still and may hide others: of large things alone, or of all. */
export function standingOf(
  things: Things,
  moved: ReadonlySet<number>,
  worldSide: number,
  alsoHandy: boolean,
): Upright[] {
  return [...things.all.values()]
    .filter((thing) => !moved.has(thing.number) && !isOverhead(thing) && top(thing) > FLAT)
    .flatMap((thing) =>
      isHandy(thing, worldSide) ? (alsoHandy ? uprightsOf(thing) : []) : uprightsOf(asWall(thing)),
    );
}

/** Things that were moved, as they are now, the lowest first. */
export function movedThings({ things, moved }: Scene): Thing[] {
  return [...moved.values()]
    .flatMap((place) => {
      const thing = things.all.get(place.number);
      return thing ? [movedTo(thing, place)] : [];
    })
    .filter((thing) => !isOverhead(thing))
    .sort((a, b) => top(a) - top(b));
}

/** Things that were moved, under robots. */
export const drawMovedThings: Layer = (context, scene) => {
  movedThings(scene).forEach((thing) => drawThing(context, thing, scene.view, scene.palette));
};

/** Things over robots, and a mark around the selected one. */
export const drawThingsOverhead: Layer = (context, { things, moved, view, palette, selectedThing }) => {
  context.globalAlpha = 0.45;
  for (const thing of byHeight(things)) {
    const place = moved.get(thing.number);
    const now = place ? movedTo(thing, place) : thing;
    if (isOverhead(now)) {
      drawThing(context, now, view, palette);
    }
  }
  context.globalAlpha = 1;
  const selected = selectedThing === null ? undefined : things.all.get(selectedThing);
  if (selected) {
    const now = movedTo(selected, moved.get(selected.number) ?? selected);
    traceBody(context, view.raised(now.pose, now.height), now.pieces, palette.accent, 3, view);
    drawThing(context, now, view, palette);
    drawHandle(
      context,
      handleAhead(now.pose, now.reach, view.scale),
      palette.accent,
      view.scale,
      palette.halo,
    );
  }
};

export function drawThing(
  context: CanvasRenderingContext2D,
  { pose, height, pieces }: Thing,
  view: View,
  palette: Palette,
) {
  const color = view.oblique ? palette.standing : palette.occupied;
  const ink = { color, line: palette.edge, lineWidth: 1 };
  drawBody(context, view.raised(pose, height), pieces, ink, view);
}

/** How many heights a thing is looked for at. */
const HEIGHTS = 12;

/** The thing that is drawn uppermost at a pixel and can be taken, if any. */
export function thingAt(
  things: Things,
  moved: ReadonlyMap<number, MovedThing>,
  at: Pixel,
  view: View,
  near: number,
  worldSide: number,
): number | null {
  let best: number | null = null;
  let highest = -Infinity;
  for (const thing of things.all.values()) {
    const place = moved.get(thing.number);
    const now = place ? movedTo(thing, place) : thing;
    if (isHandy(now, worldSide)) {
      const height = heightUnder(now, at, view, near);
      if (height !== null && height >= highest) {
        best = now.number;
        highest = height;
      }
    }
  }
  return best;
}

/** How high above the floor the way through a pixel meets a thing [m]; what it meets higher hides what it meets lower. */
function heightUnder(thing: Thing, at: Pixel, view: View, near: number): number | null {
  const [from, to] = [top(thing), low(thing)];
  for (let step = 0; step <= (view.oblique ? HEIGHTS : 0); step++) {
    const z = from + (step / HEIGHTS) * (to - from);
    if (covers(thing, thing.pose, view.toMap(at, z), near)) {
      return z;
    }
  }
  return null;
}
