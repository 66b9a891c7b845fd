import type { MovedThing } from '../../live/frame';
import { isHandy, type Thing, type Things } from '../../live/things';
import type { Palette } from '../palette';
import type { Layer } from '../scene';
import type { View } from '../view';
import { drawBody, traceBody } from './bodies';
import { isColorful } from './floor';
import { drawHandle, handleAhead } from './robots';

/** What begins as high above the floor hides robots under it [m]; it is drawn over them, to be seen through. */
const OVERHEAD = 0.6;

function low({ pieces, height }: Thing): number {
  return height + Math.min(...pieces.map((piece) => piece.low));
}

function top({ pieces, height }: Thing): number {
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

/**
 * Draws those things that are where they were told to be, which are most. In canvas coordinates.
 *
 * @param moved numbers of those that are not
 */
export function drawStillThings(
  context: CanvasRenderingContext2D,
  things: Things,
  moved: ReadonlySet<number>,
  view: View,
  palette: Palette,
  width: number,
  height: number,
  worldSide: number,
) {
  context.save();
  view.enter(context);
  for (const thing of byHeight(things)) {
    const { px, py } = view.toPixel(thing.pose);
    const reach = thing.reach * view.scale;
    const isSeen = px > -reach && px < width + reach && py > -reach && py < height + reach;
    if (isSeen && !moved.has(thing.number) && !isOverhead(thing)) {
      drawThing(context, isHandy(thing, worldSide) ? thing : asWall(thing), view.scale, palette);
    }
  }
  context.restore();
}

/** Things that were moved, the lowest first, under robots. */
export const drawMovedThings: Layer = (context, { things, moved, view, palette }) => {
  [...moved.values()]
    .flatMap((place) => {
      const thing = things.all.get(place.number);
      return thing ? [movedTo(thing, place)] : [];
    })
    .filter((thing) => !isOverhead(thing))
    .sort((a, b) => top(a) - top(b))
    .forEach((thing) => drawThing(context, thing, view.scale, palette));
};

/** Things over robots, and a mark around the selected one. */
export const drawThingsOverhead: Layer = (context, { things, moved, view, palette, selectedThing }) => {
  context.globalAlpha = 0.45;
  for (const thing of byHeight(things)) {
    const place = moved.get(thing.number);
    const now = place ? movedTo(thing, place) : thing;
    if (isOverhead(now)) {
      drawThing(context, now, view.scale, palette);
    }
  }
  context.globalAlpha = 1;
  const selected = selectedThing === null ? undefined : things.all.get(selectedThing);
  if (selected) {
    const now = movedTo(selected, moved.get(selected.number) ?? selected);
    traceBody(context, now.pose, now.pieces, palette.accent, 3, view.scale);
    drawThing(context, now, view.scale, palette);
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
  { pose, pieces }: Thing,
  scale: number,
  palette: Palette,
) {
  drawBody(context, pose, pieces, { color: palette.occupied, line: palette.edge, lineWidth: 1 }, scale);
}

/** The uppermost thing that is under a place and can be taken, if any. */
export function thingAt(
  things: Things,
  moved: ReadonlyMap<number, MovedThing>,
  isUnder: (thing: Thing) => boolean,
  worldSide: number,
): number | null {
  let best: number | null = null;
  let highest = -Infinity;
  for (const thing of things.all.values()) {
    const place = moved.get(thing.number);
    const now = place ? movedTo(thing, place) : thing;
    if (isHandy(now, worldSide) && isUnder(now) && top(now) >= highest) {
      best = now.number;
      highest = top(now);
    }
  }
  return best;
}
