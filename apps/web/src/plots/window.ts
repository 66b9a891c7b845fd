/** A part of the run's time [s]. */
export interface Window {
  readonly from: number;
  readonly until: number;
}

/** What plots show other than the newest of the time that was chosen. */
export interface View {
  readonly seconds: number;
  /** Null when it goes along with what is new. */
  readonly until: number | null;
}

/** How much of the past can be chosen to be shown at most; all of it, too [s]. */
export const SPANS = [10, 60, 300, 1800, Infinity];

/** What is shown closest [s]. */
export const CLOSEST = 1;

const MINUTE = 60;
const HOUR = 60 * MINUTE;

/** What is shown while less is known than was chosen: so nothing moves but once in a while. */
const ROUND = [10, 30, MINUTE, 120, 300, 600, 1200, 1800];

const STEPS = [0.2, 0.5, 1, 2, 5, 10, 20, 30, MINUTE, 120, 300, 600, 1200, 1800, HOUR];
/** Into so many parts a box is divided at most. */
const PARTS = 3;
/** Further to the right its end has the room for its text. */
const BEFORE_END = 0.8;

const EPSILON = 1e-6;

/**
 * The newest of what is known.
 *
 * @param chosen how much of it at most [s]
 */
export function newest(chosen: number, { from, until }: Window): Window {
  const known = Math.max(0, until - from);
  const seconds =
    chosen === Infinity && known > ROUND.at(-1)!
      ? known
      : Math.min(chosen, ROUND.find((round) => known <= round + EPSILON) ?? chosen);
  return { from: until - seconds, until };
}

/** What is shown of what is known. */
export function shownOf(view: View | null, chosen: number, known: Window): Window {
  if (view === null) {
    return newest(chosen, known);
  }
  const until = view.until ?? known.until;
  return { from: until - view.seconds, until };
}

/** That part of what is known, as far as it is; what reaches to its end goes along with it. */
export function viewOf({ from, until }: Window, known: Window): View {
  const middle = (from + until) / 2;
  const seconds = Math.min(Math.max(until - from, CLOSEST), Math.max(known.until - known.from, ROUND[0]!));
  const end = Math.max(middle + seconds / 2, known.from + seconds);
  return { seconds, until: end >= known.until - EPSILON ? null : end };
}

/** @param at which time stays where it is in the box */
export function zoomed(shown: Window, factor: number, at: number, known: Window): View {
  return viewOf({ from: at - (at - shown.from) * factor, until: at + (shown.until - at) * factor }, known);
}

/** @param by to what is later [s] */
export const moved = (shown: Window, by: number, known: Window): View =>
  viewOf({ from: shown.from + by, until: shown.until + by }, known);

/** What stands below a box: round times, and where they are, as parts of its width. */
export interface Tick {
  readonly part: number;
  readonly text: string;
}

/** As long before its end. */
export function ticksBefore(seconds: number): Tick[] {
  const step = stepOf(seconds);
  return Array.from({ length: Math.floor(seconds / step + EPSILON) }, (_, i) => (i + 1) * step)
    .reverse()
    .map((ago) => ({ part: 1 - ago / seconds, text: `−${longWords(ago, seconds)}` }));
}

/**
 * Times of the run.
 *
 * @param words of a time
 */
export function ticksIn({ from, until }: Window, words: (time: number) => string): Tick[] {
  const step = stepOf(until - from);
  const first = Math.ceil(from / step - EPSILON);
  const last = Math.floor((from + BEFORE_END * (until - from)) / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => {
    const time = (first + i) * step;
    return { part: (time - from) / (until - from), text: words(time) };
  });
}

function stepOf(seconds: number): number {
  const hours = 2 ** Math.ceil(Math.log2(seconds / PARTS / HOUR)) * HOUR;
  return STEPS.find((step) => seconds / step <= PARTS + EPSILON) ?? hours;
}

/** `20 s`, `2 min`, `1 h`: round ones, in what goes with how long the whole is. */
function longWords(seconds: number, whole: number): string {
  return whole > 3 * HOUR && seconds % HOUR === 0
    ? `${seconds / HOUR} h`
    : whole > MINUTE && seconds % MINUTE === 0
      ? `${seconds / MINUTE} min`
      : `${Number(seconds.toFixed(1))} s`;
}

/** `10 s`, `5 min`, `2.5 h` */
export function spanWords(seconds: number): string {
  const [unit, name] =
    seconds >= 2 * HOUR ? [HOUR, 'h'] : seconds >= 2 * MINUTE ? [MINUTE, 'min'] : ([1, 's'] as const);
  return `${Number((seconds / unit).toFixed(1))} ${name}`;
}
