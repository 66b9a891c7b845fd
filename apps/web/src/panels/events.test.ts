import { expect, it } from 'vitest';
import type { EventInfo } from '../api/messages';
import { filterEvents } from './events';

const events: EventInfo[] = [
  { sequence: 1, time: 0, kind: 'agent', subject: 'follow-1', text: 'hunting prey-1' },
  { sequence: 2, time: 1, kind: 'message', subject: 'escape-1', text: 'Prey is at (1, 2)' },
  { sequence: 3, time: 2, kind: 'caught', subject: 'prey-1', text: 'hunter-1 caught prey-1' },
];

const sequences = (kind: string | null, words: string) =>
  filterEvents(events, kind, words).map(({ sequence }) => sequence);

it('without a filter all events are there, newest first', () =>
  expect(sequences(null, '  ')).toEqual([3, 2, 1]));
it('a kind leaves the others out', () => expect(sequences('message', '')).toEqual([2]));
it('all words must be there, in any case and place', () => {
  expect(sequences(null, 'PREY-1 hunt')).toEqual([3, 1]);
  expect(sequences(null, 'follow-1')).toEqual([1]);
  expect(sequences('agent', 'caught')).toEqual([]);
});
