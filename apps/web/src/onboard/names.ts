import { overlap, type Box } from '../map/labels';

/** Height of a line of text [px]. */
const LINE = 14;

/** A robot's name as it is seen from another robot: where the middle of its lower edge should be [px]. */
export interface Seen {
  name: string;
  px: number;
  py: number;
  /** How far away the robot is [m]. */
  depth: number;
  width: number;
}

/** Those for which there is room, the nearest first, moved into the picture where its edge would cut them. */
export function placeNames(seen: Seen[], pictureWidth: number): Seen[] {
  const placed: Seen[] = [];
  for (const one of [...seen].sort((a, b) => a.depth - b.depth)) {
    const half = Math.min(one.width, pictureWidth) / 2;
    const moved = { ...one, px: Math.min(pictureWidth - half, Math.max(half, one.px)) };
    if (!placed.some((other) => overlap(boxOf(other), boxOf(moved)) > 0)) {
      placed.push(moved);
    }
  }
  return placed;
}

function boxOf({ px, py, width }: Seen): Box {
  return { x: px - width / 2, y: py - LINE, width, height: LINE };
}
