/** A box on the canvas [px], y down. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Something that has a name: its middle and how far it reaches around that, and how large the name is [px]. */
export interface Named {
  x: number;
  y: number;
  reach: number;
  width: number;
  height: number;
}

const GAP = 3;

/**
 * Where names stand, so that they hide neither each other nor the robots: above if that is free, else below, beside,
 * or at a corner; where all is taken, the least is hidden.
 */
export function placeLabels(named: readonly Named[]): Box[] {
  const bodies = named.map(({ x, y, reach }) => ({
    x: x - reach,
    y: y - reach,
    width: 2 * reach,
    height: 2 * reach,
  }));
  const placed: Box[] = [];
  for (const one of named) {
    const taken = [...bodies, ...placed.map(withGap)];
    const hidden = (box: Box) => taken.reduce((sum, other) => sum + overlap(box, other), 0);
    placed.push(places(one).reduce((best, next) => (hidden(next) < hidden(best) ? next : best)));
  }
  return placed;
}

function withGap({ x, y, width, height }: Box): Box {
  return { x: x - GAP, y: y - GAP, width: width + 2 * GAP, height: height + 2 * GAP };
}

/** Best first. */
function places({ x, y, reach, width, height }: Named): Box[] {
  const [left, middle, right] = [x - reach - GAP - width, x - width / 2, x + reach + GAP];
  const [above, beside, below] = [y - reach - GAP - height, y - height / 2, y + reach + GAP];
  return [
    [middle, above],
    [middle, below],
    [right, beside],
    [left, beside],
    [right, above],
    [left, above],
    [right, below],
    [left, below],
    [middle, above - height - GAP],
    [middle, below + height + GAP],
  ].map(([left, top]) => ({ x: left!, y: top!, width, height }));
}

/** Area that two boxes share. */
export function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
