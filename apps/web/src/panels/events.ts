import type { EventInfo } from '../api/messages';

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
