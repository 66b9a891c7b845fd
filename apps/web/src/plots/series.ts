/** How much of the past is kept and plotted [simulated s]. */
export const SPAN = 60;
const MOST = 1200;

/** A number over time. */
export class Series {
  private readonly times: number[] = [];
  private readonly values: (number | null)[] = [];

  /** What it is now; null when it is nothing that can be plotted. Time that goes back begins anew. */
  push(time: number, value: number | null) {
    const last = this.times.at(-1);
    if (last !== undefined && time < last) {
      this.times.length = 0;
      this.values.length = 0;
    } else if (last === time) {
      return;
    }
    this.times.push(time);
    this.values.push(value);
    const old = this.times.findIndex((each) => each >= time - SPAN);
    const excess = Math.max(old, this.times.length - MOST);
    this.times.splice(0, excess);
    this.values.splice(0, excess);
  }

  get newest(): number | null {
    return this.values.at(-1) ?? null;
  }

  /** What it was so long before the newest [s]; null when there was nothing. */
  at(ago: number): number | null {
    const then = (this.times.at(-1) ?? 0) - ago;
    const last = this.times.findLastIndex((time) => time <= then + 1e-6);
    return last === -1 ? null : (this.values[last] ?? null);
  }

  /** The least and the greatest of what is kept; null when there is nothing. */
  get range(): [number, number] | null {
    const there = this.values.filter((value) => value !== null);
    return there.length === 0 ? null : [Math.min(...there), Math.max(...there)];
  }

  /** From the oldest to the newest that is kept [s]. */
  get seconds(): number {
    return (this.times.at(-1) ?? 0) - (this.times[0] ?? 0);
  }

  /**
   * As lines in a box, the newest at its right, the greatest at its top; a gap where there was nothing.
   *
   * @param range of the box, which may be wider than its own
   * @param seconds of the box
   */
  path(
    width: number,
    height: number,
    range: readonly [number, number] | null = this.range,
    seconds = SPAN,
  ): string {
    const now = this.times.at(-1);
    if (range === null || now === undefined) {
      return '';
    }
    const [least, greatest] = range;
    const span = greatest - least;
    let drawn = false;
    return this.times
      .map((time, i) => {
        const value = this.values[i]!;
        if (value === null) {
          drawn = false;
          return '';
        }
        const x = width * (1 - (now - time) / seconds);
        const y = span === 0 ? height / 2 : height * (1 - (value - least) / span);
        const step = `${drawn ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
        drawn = true;
        return step;
      })
      .join('');
  }
}

/** From the least to the greatest of all of them; null when there is nothing. */
export function rangeOf(all: readonly Series[]): [number, number] | null {
  const ranges = all.map(({ range }) => range).filter((range) => range !== null);
  return ranges.length === 0
    ? null
    : [Math.min(...ranges.map(([least]) => least)), Math.max(...ranges.map(([, greatest]) => greatest))];
}

/** How much of the past a box shows that has room for all of them, in round numbers [s]. */
export const spanOf = (all: readonly Series[]) =>
  [10, 30].find((seconds) => all.every((series) => series.seconds <= seconds)) ?? SPAN;

/** As many digits as it takes to tell it from its neighbours. */
export function short(value: number): string {
  const size = Math.abs(value);
  return size >= 1e5 || (size > 0 && size < 1e-3)
    ? value.toExponential(1)
    : value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 || size === 0 ? 2 : 3);
}
