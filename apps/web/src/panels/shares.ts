/** Shares of panels that lie in a row or a column, in its order: percent of their room. */
export type Shares = readonly number[];

/** As tracks of a grid: none gets smaller than its least [px]. */
export function tracksOf(shares: Shares, least: readonly number[]): string {
  return shares.map((share, i) => `minmax(${String(least[i]!)}px, ${String(share)}fr)`).join(' ');
}

/**
 * Where the border after one of them is moved: what that gains the next one loses, and the others stay.
 *
 * @param sizes as they are [px]
 * @param at whose border
 * @param size that it is to have [px]
 */
export function movedTo(
  sizes: readonly number[],
  at: number,
  size: number,
  least: readonly number[],
): Shares {
  const both = sizes[at]! + sizes[at + 1]!;
  const own = Math.max(least[at]!, Math.min(size, both - least[at + 1]!));
  const after = sizes.with(at, own).with(at + 1, both - own);
  const sum = after.reduce((all, each) => all + each, 0);
  return after.map((each) => Math.round((1000 * each) / sum) / 10);
}

/** What was kept of them; null when that is none of so many. */
export function sharesIn(kept: string | null, count: number): Shares | null {
  const shares = (kept ?? '').split(' ').map(Number);
  return shares.length === count && shares.every((share) => share > 0 && share <= 100) ? shares : null;
}
