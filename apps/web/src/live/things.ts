import type { PieceInfo, ThingInfo, Things as ThingsNews } from '../api/messages';
import type { Frame, MovedThing, Pose } from './frame';
import { between } from './motion';

/** Things of at most this size can be dragged in worlds of any size [m]. */
const ALWAYS_SMALL = 3;

/** A thing of the run, as it was told. */
export interface Thing {
  number: number;
  name: string;
  /** Where it is unless a frame says otherwise. */
  pose: Pose;
  /** Of its underside above the floor [m]. */
  height: number;
  pieces: PieceInfo[];
  /** Radius around its middle that holds all of it [m]. */
  reach: number;
}

/** Things by number, in the order in which they came; each news makes a new one. */
export class Things {
  private constructor(
    readonly all: ReadonlyMap<number, Thing>,
    /** How many more there are than the server tells. */
    readonly left: number,
  ) {}

  static readonly NONE = new Things(new Map(), 0);

  after({ came, gone, left }: ThingsNews): Things {
    const all = new Map(this.all);
    gone.forEach((number) => all.delete(number));
    came.forEach((info) => all.set(info.number, thing(info)));
    return new Things(all, left);
  }
}

function thing({ number, name, x, y, heading, height, pieces }: ThingInfo): Thing {
  return { number, name, pose: { x, y, heading }, height, pieces, reach: reachOf(pieces) };
}

export function reachOf(pieces: PieceInfo[]): number {
  return Math.max(
    0,
    ...pieces.map(({ corners, radius }) => radius + Math.max(...corners.map(([x, y]) => Math.hypot(x!, y!)))),
  );
}

/** Whether a person may take it with the mouse; larger things are what others stand in. */
export function isHandy({ reach }: Thing, worldSide: number): boolean {
  return 2 * reach <= Math.max(ALWAYS_SMALL, worldSide / 4);
}

/** Whether a place is inside of a thing, or as near to it [m]. */
export function covers(
  { pieces, reach }: Thing,
  { x, y, heading }: Pose,
  at: { x: number; y: number },
  near: number,
) {
  const [dx, dy] = [at.x - x, at.y - y];
  if (Math.hypot(dx, dy) > reach + near) {
    return false;
  }
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  const [px, py] = [cos * dx + sin * dy, cos * dy - sin * dx];
  return pieces.some(({ corners, radius }) => distance(corners, px, py) <= radius + near);
}

/** From a place to an outline, or to a single point; 0 inside [m]. */
function distance(corners: number[][], px: number, py: number): number {
  let inside = false;
  let least = Infinity;
  for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
    const [ax, ay] = corners[j] as [number, number];
    const [bx, by] = corners[i] as [number, number];
    if (ay > py !== by > py && px < ((ax - bx) * (py - by)) / (ay - by) + bx) {
      inside = !inside;
    }
    const [ex, ey] = [bx - ax, by - ay];
    const length = ex * ex + ey * ey;
    const along = length === 0 ? 0 : Math.min(1, Math.max(0, ((px - ax) * ex + (py - ay) * ey) / length));
    least = Math.min(least, Math.hypot(px - ax - along * ex, py - ay - along * ey));
  }
  return inside ? 0 : least;
}

/** Where moved things are drawn between two frames, by number. */
export function blendThings(previous: Frame | null, newest: Frame, share: number): Map<number, MovedThing> {
  const before = new Map(previous?.things.map((moved) => [moved.number, moved.pose]));
  return new Map(
    newest.things.map((moved) => {
      const from = before.get(moved.number);
      return [moved.number, from ? { ...moved, pose: between(from, moved.pose, share) } : moved];
    }),
  );
}
