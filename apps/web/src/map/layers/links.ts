import type { LinkInfo } from '../../api/messages';
import type { Layer } from '../scene';
import type { Point } from '../view';
import { radius } from './robots';

/** Of arrow heads [px]. */
const HEAD = 8;
const NARROW = 3.5;
/** Between a head and the robot that it points at [px]. */
const GAP = 3;
const FAINT = 0.5;

/** A line from one robot to another, with its heads. */
export interface Line {
  from: Point;
  to: Point;
  /** Tips of arrows, the way they point as a unit vector, in map coordinates. */
  heads: { tip: Point; x: number; y: number }[];
}

/** What is drawn of links: faintly who hears whom, strongly who just did. */
export interface Lines {
  open: Line[];
  used: Line[];
}

/**
 * Who hears whom as lines: without heads where both do, with one where only that one hears. Where somebody just spoke
 * there is a head at whoever heard it.
 *
 * @param place where a robot is, by its id; null when it is nowhere
 * @param reach how far from its middle a robot is drawn [m]
 * @param pixel size of one [m]
 */
export function linesOf(
  links: readonly LinkInfo[],
  place: (robot: string) => Point | null,
  reach: (robot: string) => number,
  pixel: number,
): Lines {
  const lines: Lines = { open: [], used: [] };
  for (const { one, other, there, back, saidThere, saidBack } of links) {
    const [from, to] = [place(one), place(other)];
    const length = from && to ? Math.hypot(to.x - from.x, to.y - from.y) : 0;
    if (!from || !to || length === 0) {
      continue;
    }
    const [x, y] = [(to.x - from.x) / length, (to.y - from.y) / length];
    const head = (at: Point, robot: string, way: 1 | -1) => {
      const short = Math.min(reach(robot) + GAP * pixel, 0.4 * length);
      return { tip: { x: at.x - way * short * x, y: at.y - way * short * y }, x: way * x, y: way * y };
    };
    const line = (atOther: boolean, atOne: boolean): Line => ({
      from,
      to,
      heads: [...(atOther ? [head(to, other, 1)] : []), ...(atOne ? [head(from, one, -1)] : [])],
    });
    if (there || back) {
      lines.open.push(line(there && !back, back && !there));
    }
    if (saidThere || saidBack) {
      lines.used.push(line(saidThere, saidBack));
    }
  }
  return lines;
}

/** Which robots' agents hear each other, and which just did, on the floor between them. */
export const drawLinks: Layer = (context, { info, poses, links, view, palette }) => {
  if (links.length === 0) {
    return;
  }
  const pixel = 1 / view.scale;
  const numbers = new Map(info.robots.map(({ id }, i) => [id, i]));
  const { open, used } = linesOf(
    links,
    (robot) => poses[numbers.get(robot) ?? -1] ?? null,
    (robot) => radius(info.robots[numbers.get(robot)!]!.footprint, view.scale),
    pixel,
  );
  context.strokeStyle = palette.accent;
  context.fillStyle = palette.accent;
  context.globalAlpha = FAINT;
  drawLines(context, open, pixel, 1.25);
  context.globalAlpha = 1;
  drawLines(context, used, pixel, 2.5);
};

/** All at once: there may be a thousand. */
function drawLines(context: CanvasRenderingContext2D, lines: readonly Line[], pixel: number, width: number) {
  context.lineWidth = width * pixel;
  context.beginPath();
  for (const { from, to } of lines) {
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
  }
  context.stroke();
  context.beginPath();
  for (const { tip, x, y } of lines.flatMap(({ heads }) => heads)) {
    const [backX, backY] = [tip.x - HEAD * pixel * x, tip.y - HEAD * pixel * y];
    const [sideX, sideY] = [-NARROW * pixel * y, NARROW * pixel * x];
    context.moveTo(tip.x, tip.y);
    context.lineTo(backX + sideX, backY + sideY);
    context.lineTo(backX - sideX, backY - sideY);
    context.closePath();
  }
  context.fill();
}
