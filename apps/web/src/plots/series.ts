/** So long it is kept as it was told, so that it can be looked at closely [s of the run]. */
const RECENT = 60;

/** Of what is older only the peaks are kept, so that it does not grow for ever. */
const MOST = 12_000;

/** The shortest time of which the peaks are kept [s]; each other is twice as long as one before. */
const SHORTEST = 0.01;

/** Less than moments of a recording are apart [s]. */
const MOMENT = 0.001;

/** What is less apart is the same time [s]. */
const SAME = 1e-6;

type Value = number | null;

/** What one number was. */
export class Series {
  /** Growing. */
  times: readonly number[] = [];
  /** At these times; null where there was nothing. */
  values: readonly Value[] = [];
  private whole = false; // whether all that it ever is was told
  private played: number | null = null; // which moment of a recording was told last

  /** What it is now; what is as old as the newest, or older, counts no more. */
  push(time: number, value: Value) {
    if (time > this.until) {
      (this.times as number[]).push(time);
      (this.values as Value[]).push(value);
      this.thin();
    }
  }

  /**
   * What somebody else knows of it, before, between and after what is known here.
   *
   * @param times growing
   */
  merge(times: readonly number[], values: readonly Value[]) {
    const [allTimes, allValues]: [number[], Value[]] = [[], []];
    let own = 0;
    for (let i = 0; i <= times.length; i++) {
      const next = times[i] ?? Infinity;
      for (; own < this.times.length && this.times[own]! <= next; own++) {
        allTimes.push(this.times[own]!);
        allValues.push(this.values[own]!);
      }
      if (i < times.length && next !== allTimes.at(-1)) {
        allTimes.push(next);
        allValues.push(values[i] ?? null);
      }
    }
    this.times = allTimes;
    this.values = allValues;
    this.thin();
  }

  /**
   * All that it ever is, of a recording: what was played of it before counts no more.
   *
   * @param times growing
   */
  learn(times: readonly number[], values: readonly Value[]) {
    this.times = [...times];
    this.values = [...values];
    this.whole = true;
    this.thin();
  }

  /**
   * What it is at a moment of a recording, which is played from anywhere. When that is another piece than what was
   * played before, nobody knows what was between them, unless all of it is known.
   *
   * @param farthest between moments of the same piece [s]
   */
  play(time: number, value: Value, farthest: number) {
    const before = this.played;
    this.played = time;
    if (!this.whole && before !== null && (time < before || time - before > farthest)) {
      const [first, last] = [before + MOMENT, time - MOMENT];
      this.merge(first < last ? [first, last] : [last, first], [null, null]);
    }
    if (time > this.until) {
      this.push(time, value);
    } else {
      this.insert(time, value);
    }
  }

  /** What it was at a time that is not the newest, unless that is known. */
  private insert(time: number, value: Value) {
    const at = this.after(time);
    if (this.times[at - 1] !== time) {
      (this.times as number[]).splice(at, 0, time);
      (this.values as Value[]).splice(at, 0, value);
      this.thin();
    }
  }

  private thin() {
    if (this.times.length <= MOST) {
      return;
    }
    const recent = this.after(this.until - RECENT);
    const older = recent > this.times.length / 2 ? recent : this.times.length; // the last minute alone has too many
    let kept: number[];
    let length = SHORTEST;
    do {
      kept = this.peaks(0, older, (i) => Math.floor(this.times[i]! / length));
      length *= 2;
    } while (kept.length + this.times.length - older > 0.75 * MOST);
    for (let i = older; i < this.times.length; i++) {
      kept.push(i);
    }
    this.times = kept.map((i) => this.times[i]!);
    this.values = kept.map((i) => this.values[i]!);
  }

  /**
   * Of those that are in one part, one after the other: the first, the least, the greatest, the last, and the first
   * where there is nothing.
   *
   * @param from of which on
   * @param end before which
   * @param part in which one is: a number that grows
   * @param ends whether the first and the last are among them
   */
  private peaks(from: number, end: number, part: (i: number) => number, ends = false): number[] {
    const all: number[] = [];
    let first = from;
    while (first < end) {
      const here = part(first);
      let [least, greatest, gap, i] = [-1, -1, -1, first];
      for (; i < end && part(i) === here; i++) {
        const value = this.values[i]!;
        if (value === null) {
          gap = gap === -1 ? i : gap;
          continue;
        }
        least = least === -1 || value < this.values[least]! ? i : least;
        greatest = greatest === -1 || value > this.values[greatest]! ? i : greatest;
      }
      if (ends) {
        all.push(first);
      }
      // in their order, each once; of each of many parts, many times a second: no array is sorted
      const [low, high] = least < greatest ? [least, greatest] : [greatest, least];
      add(all, Math.min(low, gap));
      add(all, Math.max(low, Math.min(high, gap)));
      add(all, Math.max(high, gap));
      if (ends) {
        add(all, i - 1);
      }
      first = i;
    }
    return all;
  }

  /** Whether there is nothing more to be known of it. */
  get isWhole(): boolean {
    return this.whole;
  }

  /** When the newest was; −∞ when there is none. */
  get until(): number {
    return this.times.at(-1) ?? -Infinity;
  }

  /** When the oldest was; ∞ when there is none. */
  get from(): number {
    return this.times[0] ?? Infinity;
  }

  /** What it was then; null when nobody knows, or there was nothing. */
  at(time: number): Value {
    return this.values[this.after(time + SAME) - 1] ?? null;
  }

  /** The index of the first that is later; as many as there are when none is. */
  private after(time: number): number {
    let [low, high] = [0, this.times.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle]! <= time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** The least and the greatest from one time to another; null when there was nothing. */
  range(from = -Infinity, until = Infinity): [number, number] | null {
    let [least, greatest] = [Infinity, -Infinity];
    for (let i = this.after(from - SAME); i < this.times.length && this.times[i]! <= until + SAME; i++) {
      const value = this.values[i]!;
      if (value !== null) {
        least = Math.min(least, value);
        greatest = Math.max(greatest, value);
      }
    }
    return least > greatest ? null : [least, greatest];
  }

  /**
   * As lines in a box, the latest time at its right, the greatest value at its top; a gap where there was nothing. They
   * lead on to what is next outside of the box. Where there is more than can be told apart, the peaks are drawn.
   *
   * @param range of values in the box
   * @param until which time is at its right
   * @param seconds of the box
   */
  path(
    width: number,
    height: number,
    [least, greatest]: readonly [number, number],
    until: number,
    seconds: number,
  ): string {
    const from = until - seconds;
    const first = Math.max(0, this.after(from - SAME) - 1);
    const end = Math.min(this.times.length, this.after(until + SAME) + 1);
    if (this.range(from, until) === null) {
      return '';
    }
    const span = greatest - least;
    let drawn = false;
    return this.peaks(first, end, (i) => Math.floor((2 * width * (this.times[i]! - from)) / seconds), true)
      .map((i) => {
        const value = this.values[i]!;
        if (value === null) {
          drawn = false;
          return '';
        }
        const x = width * (1 - (until - this.times[i]!) / seconds);
        const y = span === 0 ? height / 2 : height * (1 - (value - least) / span);
        const step = `${drawn ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
        drawn = true;
        return step;
      })
      .join('');
  }
}

/** What is there, unless it is the last of them. */
function add(all: number[], one: number) {
  if (one !== -1 && one !== all.at(-1)) {
    all.push(one);
  }
}

/** From the least to the greatest of all of them; null when there is nothing. */
export function rangeOf(all: readonly Series[], from?: number, until?: number): [number, number] | null {
  const ranges = all.map((series) => series.range(from, until)).filter((range) => range !== null);
  return ranges.length === 0
    ? null
    : [Math.min(...ranges.map(([least]) => least)), Math.max(...ranges.map(([, greatest]) => greatest))];
}
