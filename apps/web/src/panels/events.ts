import type { EventInfo } from '../api/messages';
import { texts } from '../texts';

/** Those of a kind (any, when `null`) whose text, kind or subject has the words; newest first. */
export function filterEvents(events: readonly EventInfo[], kind: string | null, words: string): EventInfo[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  return events
    .filter((event) => {
      const text = `${event.kind} ${event.subject} ${event.text}`.toLowerCase();
      return (kind === null || event.kind === kind) && wanted.every((word) => text.includes(word));
    })
    .reverse();
}

/** Several messages of one agent about the same, or one event of any kind. */
export interface EventLine {
  /** The newest of them. */
  event: EventInfo;
  /** When the first of them was [s]. */
  since: number;
  /** Sequence of the first. */
  first: number;
  times: number;
  /** To whom they were said in conversations, each once; none when they were said to all. */
  partners: string[];
  /** What was said, without the partner: `cfp: fetch the can`. */
  gist: string;
  /** Whether that is what was said each time. */
  same: boolean;
}

const SPAN = 30; // s; so long one line may go on, then there is another

/** One event by itself. */
export function lineOf(event: EventInfo): EventLine {
  const { said, text } = event;
  return {
    event,
    since: event.time,
    first: event.sequence,
    times: 1,
    partners: said?.act ? [said.to] : [],
    gist: said?.act ? text.slice(`${said.to}, `.length) : text,
    same: true,
  };
}

/** What a line says, for people. */
export function words({ event, times, partners, gist, same }: EventLine): string {
  if (times === 1 || partners.length === 0) {
    return event.text;
  }
  const { act } = event.said!;
  return texts.events.said(act, partners) + (same ? '' : texts.events.lastly) + gist.slice(act.length);
}

/** What messages have in common that are one line: in conversations the act, else the words but for the numbers. */
function topic({ event, partners, gist }: EventLine): string {
  const about = partners.length > 0 ? event.said!.act : gist.replace(/-?\d+(\.\d+)?/g, '#');
  return `${Math.floor(event.time / SPAN)} ${event.subject} ${about}`;
}

/**
 * The newest events, newest first, at most so many lines: what one agent says again and again within half a minute is
 * one line, at the place of the newest. Looks only as far back as it must.
 */
export function foldEvents(events: readonly EventInfo[], most: number): EventLine[] {
  const lines: EventLine[] = [];
  const byTopic = new Map<string, EventLine>();
  for (let i = events.length - 1; i >= 0; i--) {
    const event = events[i] as EventInfo;
    const span = Math.floor(event.time / SPAN);
    const last = lines[lines.length - 1];
    if (lines.length >= most && last && Math.floor(last.event.time / SPAN) !== span) {
      break; // what is left is of other lines
    }
    const line = lineOf(event);
    const key = event.kind === 'message' ? topic(line) : '';
    const known = byTopic.get(key);
    if (key && known) {
      known.times++;
      known.same &&= known.gist === line.gist;
      known.since = event.time;
      known.first = event.sequence;
      line.partners
        .filter((partner) => !known.partners.includes(partner))
        .forEach((it) => known.partners.push(it));
    } else {
      lines.push(line);
      if (key) {
        byTopic.set(key, line);
      }
    }
  }
  return lines.slice(0, most);
}
