import { movedTo, sharesIn, tracksOf, type Shares } from './shares';

/** How panels lie: one above the other, side by side, or two side by side above the third. */
export type Layout = 'rows' | 'columns' | 'corner';
/** Along which they share their room. */
export type Axis = 'rows' | 'columns';

/** The least that a panel keeps [px]. */
const LEAST: Record<Layout, Partial<Record<Axis, readonly number[]>>> = {
  rows: { rows: [150, 120, 120] },
  columns: { columns: [320, 220, 340] },
  corner: { columns: [320, 240], rows: [220, 160] },
};

/** Where somebody has moved the borders between the panels, for each way in which they lie; it is remembered. */
class Sharing {
  private readonly kept = $state<Record<string, Shares | null>>({});

  constructor() {
    for (const layout of ['rows', 'columns', 'corner'] as const) {
      for (const [axis, least] of Object.entries(LEAST[layout])) {
        this.kept[keyOf(layout, axis)] = sharesIn(localStorage.getItem(keyOf(layout, axis)), least.length);
      }
    }
  }

  leastOf(layout: Layout, axis: Axis): readonly number[] {
    return LEAST[layout][axis]!;
  }

  /** Tracks of the grid of panels; null where nobody has moved a border. */
  tracks(layout: Layout | null, axis: Axis): string | null {
    const shares = layout && this.kept[keyOf(layout, axis)];
    return shares ? tracksOf(shares, LEAST[layout!][axis]!) : null;
  }

  /**
   * Gives one of them another size; all their own again when that is null.
   *
   * @param sizes of all along the axis [px]
   */
  move(layout: Layout, axis: Axis, sizes: readonly number[], at: number, size: number | null) {
    const key = keyOf(layout, axis);
    this.kept[key] = size === null ? null : movedTo(sizes, at, size, LEAST[layout][axis]!);
    if (this.kept[key] === null) {
      localStorage.removeItem(key);
    } else {
      localStorage.setItem(key, this.kept[key].join(' '));
    }
  }
}

const keyOf = (layout: Layout, axis: string) => `rsal.shares.${layout}.${axis}`;

export const sharing = new Sharing();
