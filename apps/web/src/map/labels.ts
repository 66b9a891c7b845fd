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
  /** Whether its name is seen whatever that hides, and stands where it likes best. */
  first?: boolean;
}

const GAP = 3;
/** Of more than so many, only those names are seen that hide nothing: all of them would be one heap. */
const CROWD = 40;

/**
 * Where names stand, so that they hide neither each other nor the robots: above if that is free, else below, beside,
 * or at a corner; where all is taken, the least is hidden, or in a crowd there is no name.
 */
export function placeLabels(named: readonly Named[]): (Box | null)[] {
  const taken = new Taken();
  named.forEach(({ x, y, reach }) =>
    taken.add({ x: x - reach, y: y - reach, width: 2 * reach, height: 2 * reach }),
  );
  const placed: (Box | null)[] = named.map(() => null);
  const place = (one: Named, i: number) => {
    const spots = places(one);
    const crowded = named.length > CROWD && !one.first;
    const box = spots.find((spot) => taken.isFree(spot)) ?? (crowded ? null : leastHiding(spots, taken));
    if (box) {
      placed[i] = box;
      taken.add(withGap(box));
    }
  };
  named.forEach((one, i) => one.first && place(one, i));
  named.forEach((one, i) => one.first || place(one, i));
  return placed;
}

function leastHiding(spots: readonly Box[], taken: Taken): Box {
  const hidden = spots.map((spot) => taken.under(spot));
  return spots[hidden.indexOf(Math.min(...hidden))]!;
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

/** What is taken, by squares of the canvas, so that a box is held against its neighbors only. */
class Taken {
  private static readonly SIDE = 64;
  private static readonly COLUMN = 1 << 16; // two squares that share a number cost time, nothing else
  private readonly squares = new Map<number, Box[]>();

  add(box: Box) {
    Taken.some(box, (square) => {
      const there = this.squares.get(square);
      if (there) {
        there.push(box);
      } else {
        this.squares.set(square, [box]);
      }
      return false;
    });
  }

  isFree(box: Box): boolean {
    return !Taken.some(
      box,
      (square) => this.squares.get(square)?.some((other) => overlap(box, other) > 0) === true,
    );
  }

  /** How much of what is taken is under a box [px²]. */
  under(box: Box): number {
    const boxes = new Set<Box>(); // each may be in several squares
    Taken.some(box, (square) => {
      this.squares.get(square)?.forEach((other) => boxes.add(other));
      return false;
    });
    return [...boxes].reduce((sum, other) => sum + overlap(box, other), 0);
  }

  /** Whether something is so of any square that a box is in. */
  private static some({ x, y, width, height }: Box, holds: (square: number) => boolean): boolean {
    const [right, bottom] = [Math.floor((x + width) / Taken.SIDE), Math.floor((y + height) / Taken.SIDE)];
    for (let column = Math.floor(x / Taken.SIDE); column <= right; column++) {
      for (let row = Math.floor(y / Taken.SIDE); row <= bottom; row++) {
        if (holds(column * Taken.COLUMN + row)) {
          return true;
        }
      }
    }
    return false;
  }
}
