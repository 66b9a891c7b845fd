import type { EventInfo } from '../api/messages';

/** Kinds of events that are marked, those that count most first; others are in the list of events only. */
const KINDS = ['fault', 'caught', 'collision', 'unreached', 'operator', 'health', 'goal', 'run'];

/** Events that are so near each other that they have one mark. */
export interface Mark {
  /** Of the first of the kind that counts most [s]. */
  time: number;
  /** Which counts most among them. */
  kind: string;
  /** What happened, in the order in which it did; the first few. */
  events: EventInfo[];
  /** How many more there are. */
  left: number;
  /** Where it is: 0 at the beginning, 1 at the end. */
  share: number;
}

const MOST_TOLD = 6; // of one mark

export function marksAmong(events: readonly EventInfo[]): EventInfo[] {
  return events.filter(({ kind }) => KINDS.includes(kind));
}

/**
 * Marks on a timeline, earliest first.
 *
 * @param events those of {@link marksAmong}, oldest first
 * @param most how many marks there is room for
 */
export function marksOf(events: readonly EventInfo[], from: number, until: number, most: number): Mark[] {
  const marks = new Map<number, Mark>(); // by place
  for (const event of events) {
    const share = shareOf(event.time, from, until);
    const place = Math.min(most - 1, Math.floor(share * most));
    const known = marks.get(place);
    if (!known) {
      marks.set(place, { time: event.time, kind: event.kind, events: [event], left: 0, share });
      continue;
    }
    if (KINDS.indexOf(event.kind) < KINDS.indexOf(known.kind)) {
      Object.assign(known, { time: event.time, kind: event.kind, share });
    }
    if (known.events.length < MOST_TOLD) {
      known.events.push(event);
    } else {
      known.left++;
    }
  }
  return [...marks.values()];
}

/** Where a time is between two others, from 0 to 1. */
export function shareOf(time: number, from: number, until: number): number {
  return until > from ? Math.min(1, Math.max(0, (time - from) / (until - from))) : 0;
}
