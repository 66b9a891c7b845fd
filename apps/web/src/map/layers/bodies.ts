import type { PieceInfo } from '../../api/messages';
import type { Context } from '../context';
import type { Pose } from '../../live/frame';
import { shaded } from '../palette';
import type { Point, View } from '../view';
import { enter } from './frames';
import { lightOf } from './relief';

/** Outlines in a body's own frame, made once. */
const outlines = new WeakMap<PieceInfo, Path2D>();

function outlineOf(piece: PieceInfo): Path2D {
  let path = outlines.get(piece);
  if (!path) {
    path = new Path2D();
    const { corners, radius } = piece;
    if (radius > 0) {
      const [x, y] = corners[0] as [number, number];
      path.arc(x, y, radius, 0, 2 * Math.PI);
    } else {
      corners.forEach(([x, y]) => path!.lineTo(x!, y!));
    }
    path.closePath();
    outlines.set(piece, path);
  }
  return path;
}

/** All that bodies cover, in the map frame. */
export function areaOf(bodies: readonly { pose: Pose; pieces: readonly PieceInfo[] }[]): Path2D {
  const area = new Path2D();
  for (const { pose, pieces } of bodies) {
    const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
    for (const piece of pieces) {
      // all turn the same way, so that none is cut out of another
      const corners = isCounterClockwise(piece) ? piece.corners : [...piece.corners].reverse();
      corners.forEach(([bodyX, bodyY], i) => {
        const x = pose.x + cos * bodyX! - sin * bodyY!;
        const y = pose.y + sin * bodyX! + cos * bodyY!;
        if (piece.radius > 0) {
          area.moveTo(x + piece.radius, y);
          area.arc(x, y, piece.radius, 0, 2 * Math.PI);
        } else if (i === 0) {
          area.moveTo(x, y);
        } else {
          area.lineTo(x, y);
        }
      });
      area.closePath();
    }
  }
  return area;
}

/** Whether two pieces look like one where they touch. */
function isLevel(a: PieceInfo, b: PieceInfo): boolean {
  return a.high === b.high && a.color === b.color;
}

export interface Ink {
  /** Of pieces that have none. */
  color: string;
  line: string;
  /** Of what is seen of the line, outside of the body [px]; 0 for none. */
  lineWidth: number;
}

/**
 * Draws a body: its pieces, the lowest first; as seen from above or, in an oblique view, with their sides.
 *
 * @param grown how much larger than it is
 */
export function drawBody(
  context: Context,
  pose: Pose,
  pieces: readonly PieceInfo[],
  ink: Ink,
  view: View,
  grown = 1,
) {
  const up = upIn(pose, view);
  context.save();
  enter(context, pose);
  context.scale(grown, grown);
  context.lineJoin = 'round';
  context.lineWidth = (2 * ink.lineWidth) / (view.scale * grown);
  context.strokeStyle = ink.line;
  for (let from = 0, to = 0; from < pieces.length; from = to) {
    while (to < pieces.length && isLevel(pieces[from]!, pieces[to]!)) {
      to++;
    }
    const { color, high } = pieces[from]!;
    if (view.oblique) {
      for (let i = from; i < to; i++) {
        drawSides(context, pieces[i]!, up, color ?? ink.color, ink.lineWidth > 0);
      }
    }
    context.translate(high * up.x, high * up.y);
    for (let i = from; ink.lineWidth > 0 && i < to; i++) {
      context.stroke(outlineOf(pieces[i]!));
    }
    context.fillStyle = color ?? ink.color;
    for (let i = from; i < to; i++) {
      context.fill(outlineOf(pieces[i]!));
    }
    context.translate(-high * up.x, -high * up.y);
  }
  context.restore();
}

/** Where a metre of height is drawn, in a body's own frame. */
function upIn({ heading }: Pose, { up }: View): Point {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return { x: cos * up.x + sin * up.y, y: cos * up.y - sin * up.x };
}

/** Draws what is seen of a piece below its top, in the body's frame: first what the light falls on least. */
function drawSides(context: Context, piece: PieceInfo, up: Point, color: string, line: boolean) {
  if (piece.radius > 0) {
    traceRound(context, piece, up);
    drawTraced(context, shaded(color, lightOf(-up.x, -up.y, up)), line);
    return;
  }
  const { corners, low, high } = piece;
  const turning = isCounterClockwise(piece) ? 1 : -1;
  for (let b = 0, a = corners.length - 1; b < corners.length; a = b++) {
    const [ax, ay] = corners[a] as [number, number];
    const [bx, by] = corners[b] as [number, number];
    const [nx, ny] = [turning * (by - ay), turning * (ax - bx)];
    const length = Math.hypot(nx, ny);
    if (nx * up.x + ny * up.y < -1e-9 * length) {
      context.beginPath();
      context.moveTo(ax + low * up.x, ay + low * up.y);
      context.lineTo(bx + low * up.x, by + low * up.y);
      context.lineTo(bx + high * up.x, by + high * up.y);
      context.lineTo(ax + high * up.x, ay + high * up.y);
      context.closePath();
      drawTraced(context, shaded(color, lightOf(nx / length, ny / length, up)), line);
    }
  }
}

function drawTraced(context: Context, color: string, line: boolean) {
  if (line) {
    context.stroke();
  }
  context.fillStyle = color;
  context.fill();
}

function traceRound(context: Context, { corners, radius, low, high }: PieceInfo, up: Point) {
  const [x, y] = corners[0] as [number, number];
  const direction = Math.atan2(up.y, up.x);
  context.beginPath();
  context.arc(x + low * up.x, y + low * up.y, radius, direction + Math.PI / 2, direction - Math.PI / 2);
  context.arc(x + high * up.x, y + high * up.y, radius, direction - Math.PI / 2, direction + Math.PI / 2);
  context.closePath();
}

const turnings = new WeakMap<PieceInfo, boolean>();

function isCounterClockwise(piece: PieceInfo): boolean {
  let turning = turnings.get(piece);
  if (turning === undefined) {
    const { corners } = piece;
    let area = 0;
    corners.forEach(([x, y], i) => {
      const [nextX, nextY] = corners[(i + 1) % corners.length] as [number, number];
      area += x! * nextY - nextX * y!;
    });
    turning = area > 0;
    turnings.set(piece, turning);
  }
  return turning;
}

/** The outline around a body's pieces, as a line. */
export function traceBody(
  context: Context,
  pose: Pose,
  pieces: readonly PieceInfo[],
  color: string,
  pixels: number,
  view: View,
) {
  drawBody(context, pose, pieces, { color, line: color, lineWidth: pixels }, view);
}
