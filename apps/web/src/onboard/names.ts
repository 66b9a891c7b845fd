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
    if (!placed.some((other) => overlap(other, moved))) {
      placed.push(moved);
    }
  }
  return placed;
}

function overlap(a: Seen, b: Seen): boolean {
  return Math.abs(a.px - b.px) < (a.width + b.width) / 2 && Math.abs(a.py - b.py) < LINE;
}
