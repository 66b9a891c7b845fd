import type { EventInfo, RoutineInfo, SaidInfo } from '../api/messages';
import { brief } from '../format';

/** What to show of all that was said: what meets each of these, which are empty for any. */
export interface Wanted {
  /** Who says it, or hears it by name. */
  agent: string;
  /** Of one topic, or all [CONVERSATIONS]. */
  topic: string;
  protocol: string;
  /** Id of a conversation. */
  conversation: string;
}

/** Whatever is part of one, or said to one agent: no topic is called so. */
export const CONVERSATIONS = '*';

export const ANY: Wanted = { agent: '', topic: '', protocol: '', conversation: '' };

/** Something that was said, as a line from one column to another. */
export interface Arrow {
  sequence: number;
  time: number;
  from: number;
  /** Null when it is for whoever listens. */
  to: number | null;
  /** The act of a conversation, else what it says. */
  label: string;
  /** What it says. */
  words: string;
  conversation: string;
  /** Whether it turns something down, or says that it failed. */
  refuses: boolean;
  /** How often it was said to all, one soon after the other, from then on. */
  times: number;
}

export interface Sequence {
  /** Names of the columns: agents, in the order in which they spoke or were spoken to first in the run. */
  agents: string[];
  /** Oldest first. */
  arrows: Arrow[];
  /** How many older ones are not among them. */
  left: number;
}

/** What there is to choose from. */
export interface Choice {
  agents: string[];
  topics: string[];
  protocols: string[];
}

const REFUSALS = new Set(['refuse', 'reject-proposal', 'failure', 'not-understood', 'cancel']);

/** What is said again later than that is no repetition [s]. */
const SOON = 30;

/** The newest arrows of those that are wanted, at most so many. Repetitions count as one, unless a topic is wanted. */
export function sequenceOf(events: readonly EventInfo[], wanted: Wanted, most: number): Sequence {
  const some = events.filter((event) => isWanted(event, wanted));
  const times =
    wanted.topic === ANY.topic ? withoutRepetitions(some) : new Map(some.map((event) => [event, 1]));
  const all = [...times.keys()];
  const shown = all.slice(-most);
  const there = new Set(shown.flatMap(partners));
  const agents = [...new Set(events.flatMap(partners))].filter((name) => there.has(name));
  const column = new Map(agents.map((name, i) => [name, i]));
  return {
    agents,
    arrows: shown.map((event) => arrowOf(event, column, times.get(event)!)),
    left: all.length - shown.length,
  };
}

/** What was said, and how often: what one agent says to all in the same words soon afterwards is said once. */
function withoutRepetitions(events: readonly EventInfo[]): Map<EventInfo, number> {
  const times = new Map<EventInfo, number>();
  const lately = new Map<string, { first: EventInfo; last: number }>();
  events.forEach((event) => {
    const said = event.said!;
    if (isTalk(said)) {
      times.set(event, 1);
      return;
    }
    const key = JSON.stringify([event.subject, said.topic, event.text]);
    const before = lately.get(key);
    if (before && event.time - before.last <= SOON) {
      before.last = event.time;
      times.set(before.first, times.get(before.first)! + 1);
    } else {
      lately.set(key, { first: event, last: event.time });
      times.set(event, 1);
    }
  });
  return times;
}

export function choiceOf(events: readonly EventInfo[]): Choice {
  const said = events.flatMap((event) => event.said ?? []);
  const different = (names: string[]) => [...new Set(names)].sort();
  return {
    agents: different(events.flatMap(partners)),
    topics: different(said.map(({ topic }) => topic)),
    protocols: different(said.map(({ protocol }) => protocol)).filter((name) => name !== ''),
  };
}

/** Of events and of what is said so often that it is none, what is about a topic, oldest first. */
export function withRoutine(
  events: readonly EventInfo[],
  routine: readonly RoutineInfo[],
): readonly EventInfo[] {
  if (routine.length === 0) {
    return events;
  }
  const all = routine.map(({ time, from, text, said }, i) => ({
    sequence: -1 - i, // events count from 1
    time,
    kind: 'message',
    subject: from,
    text,
    said,
  }));
  return [...events, ...all].sort((a, b) => a.time - b.time);
}

export const hasConversations = (events: readonly EventInfo[]): boolean =>
  events.some(({ said }) => said !== null && isTalk(said));

/** Whether it is part of a conversation. Agents in AgentSpeak have some, too, of which only they know which is which. */
const isTalk = ({ to, conversation }: SaidInfo): boolean => conversation !== '' || to !== '';

function isWanted({ subject, said }: EventInfo, { agent, topic, protocol, conversation }: Wanted): boolean {
  return (
    said !== null &&
    (agent === '' || agent === subject || agent === said.to) &&
    (topic === '' || (topic === CONVERSATIONS ? isTalk(said) : topic === said.topic)) &&
    (protocol === '' || protocol === said.protocol) &&
    (conversation === '' || conversation === said.conversation)
  );
}

function partners({ subject, said }: EventInfo): string[] {
  return said === null ? [] : said.to === '' ? [subject] : [subject, said.to];
}

function arrowOf(event: EventInfo, column: ReadonlyMap<string, number>, times: number): Arrow {
  const said = event.said!;
  return {
    sequence: event.sequence,
    time: event.time,
    from: column.get(event.subject)!,
    to: said.to === '' ? null : column.get(said.to)!,
    label: said.act || brief(event.text),
    words: brief(event.text),
    conversation: said.conversation,
    refuses: REFUSALS.has(said.act),
    times,
  };
}
