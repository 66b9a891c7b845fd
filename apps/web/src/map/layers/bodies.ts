import type { PieceInfo } from '../../api/messages';
import type { Pose } from '../../live/frame';
import { enter } from './frames';

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

/** Whether two pieces look like one where they touch. */
function isLevel(a: PieceInfo, b: PieceInfo): boolean {
  return a.high === b.high && a.color === b.color;
}

export interface Ink {
  /** Of pieces that have none. */
  color: string;
  line: string;
  /** Of what is seen of the line, outside of the body [px]. */
  lineWidth: number;
}

/**
 * Draws a body as seen from above: its pieces, the lowest first.
 *
 * @param scale pixels per metre
 * @param grown how much larger than it is
 */
export function drawBody(
  context: CanvasRenderingContext2D,
  pose: Pose,
  pieces: readonly PieceInfo[],
  ink: Ink,
  scale: number,
  grown = 1,
) {
  context.save();
  enter(context, pose);
  context.scale(grown, grown);
  context.lineJoin = 'round';
  context.lineWidth = (2 * ink.lineWidth) / (scale * grown);
  context.strokeStyle = ink.line;
  for (let from = 0, to = 0; from < pieces.length; from = to) {
    while (to < pieces.length && isLevel(pieces[from]!, pieces[to]!)) {
      context.stroke(outlineOf(pieces[to++]!));
    }
    context.fillStyle = pieces[from]!.color ?? ink.color;
    pieces.slice(from, to).forEach((piece) => context.fill(outlineOf(piece)));
  }
  context.restore();
}

/** The outline around a body's pieces, as a line. */
export function traceBody(
  context: CanvasRenderingContext2D,
  pose: Pose,
  pieces: readonly PieceInfo[],
  color: string,
  pixels: number,
  scale: number,
) {
  drawBody(context, pose, pieces, { color, line: color, lineWidth: pixels }, scale);
}
