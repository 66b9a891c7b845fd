/** How much of the past is shown at most [s of the run]. */
export const SPAN = 60;

/** Older than what is shown now it is kept more coarsely, so that it does not grow for ever. */
const MOST = 4000;

/** Less than moments of a recording are apart [s]. */
const MOMENT = 0.001;

/** What one number was. */
export class Series {
  private times: number[] = []; // growing
  private values: (number | null)[] = [];
  private played: number | null = null; // which moment of a recording was told last

  /** What it is now; what is as old as the newest, or older, counts no more. */
  push(time: number, value: number | null) {
    if (time > this.until) {
      this.times.push(time);
      this.values.push(value);
      this.thin();
    }
  }

  /** What somebody else knows of it, before, between and after what is known here. */
  merge(times: readonly number[], values: readonly (number | null)[]) {
    const all = new Map(times.map((time, i) => [time, values[i] ?? null]));
    this.times.forEach((time, i) => all.set(time, this.values[i]!));
    const sorted = [...all].sort(([a], [b]) => a - b);
    this.times = sorted.map(([time]) => time);
    this.values = sorted.map(([, value]) => value);
    this.thin();
  }

  /**
   * What it is at a moment of a recording, which is played from anywhere. When that is another piece than what was
   * played before, nobody knows what was between them.
   *
   * @param farthest between moments of the same piece [s]
   */
  play(time: number, value: number | null, farthest: number) {
    const before = this.played;
    this.played = time;
    if (before !== null && (time < before || time - before > farthest)) {
      this.merge([before + MOMENT, time - MOMENT], [null, null]);
    }
    if (time > this.until) {
      this.push(time, value); // as most are: nothing is to be sorted
    } else {
      this.merge([time], [value]);
    }
  }

  private thin() {
    if (this.times.length <= MOST) {
      return;
    }
    while (this.times.length > 0.75 * MOST) {
      const older = this.times.findIndex((time) => time >= this.until - SPAN);
      const all = older < this.times.length / 2; // the last minute alone has too many
      const isKept = (i: number) => i % 2 === 0 || (i >= older && !all);
      this.values = this.values.filter((_, i) => isKept(i));
      this.times = this.times.filter((_, i) => isKept(i));
    }
  }

  /** When the newest was; −∞ when there is none. */
  get until(): number {
    return this.times.at(-1) ?? -Infinity;
  }

  /** What it was then; null when nobody knows, or there was nothing. */
  at(time: number): number | null {
    const last = this.times.findLastIndex((each) => each <= time + 1e-6);
    return last === -1 ? null : (this.values[last] ?? null);
  }

  /** Times and values from one time to another. */
  private within(from: number, until: number): [number, number | null][] {
    return this.times.flatMap((time, i): [number, number | null][] =>
      time >= from - 1e-6 && time <= until + 1e-6 ? [[time, this.values[i]!]] : [],
    );
  }

  /** The least and the greatest from one time to another; null when there was nothing. */
  range(from = -Infinity, until = Infinity): [number, number] | null {
    const there = this.within(from, until).flatMap(([, value]) => (value === null ? [] : [value]));
    return there.length === 0 ? null : [Math.min(...there), Math.max(...there)];
  }

  /** How far back before a time it is known, of what can be shown [s]. */
  seconds(until: number): number {
    return Math.min(SPAN, Math.max(0, until - (this.times[0] ?? until)));
  }

  /**
   * As lines in a box, the latest time at its right, the greatest value at its top; a gap where there was nothing.
   *
   * @param range of values in the box
   * @param until which time is at its right
   * @param seconds of the box
   */
  path(
    width: number,
    height: number,
    [least, greatest]: readonly [number, number],
    until = this.until,
    seconds = SPAN,
  ): string {
    const span = greatest - least;
    let drawn = false;
    return this.within(until - seconds, until)
      .map(([time, value]) => {
        if (value === null) {
          drawn = false;
          return '';
        }
        const x = width * (1 - (until - time) / seconds);
        const y = span === 0 ? height / 2 : height * (1 - (value - least) / span);
        const step = `${drawn ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
        drawn = true;
        return step;
      })
      .join('');
  }
}

/** From the least to the greatest of all of them; null when there is nothing. */
export function rangeOf(all: readonly Series[], from?: number, until?: number): [number, number] | null {
  const ranges = all.map((series) => series.range(from, until)).filter((range) => range !== null);
  return ranges.length === 0
    ? null
    : [Math.min(...ranges.map(([least]) => least)), Math.max(...ranges.map(([, greatest]) => greatest))];
}

/** How much of the past a box shows that has room for all of them, in round numbers [s]. */
export const spanOf = (all: readonly Series[], until: number) =>
  [10, 30].find((seconds) => all.every((series) => series.seconds(until) <= seconds)) ?? SPAN;
