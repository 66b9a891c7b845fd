import { expect, it } from 'vitest';
import type { EventInfo, SaidInfo } from '../api/messages';
import { filterEvents, foldEvents, words } from './events';

const events: EventInfo[] = [
  { sequence: 1, time: 0, kind: 'agent', subject: 'follow-1', text: 'hunting prey-1', said: null },
  { sequence: 2, time: 1, kind: 'message', subject: 'escape-1', text: 'Prey is at (1, 2)', said: null },
  { sequence: 3, time: 2, kind: 'caught', subject: 'prey-1', text: 'hunter-1 caught prey-1', said: null },
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

/** What a conversation's text tells: `follow-1, cfp: hunt prey-1`. */
function saidIn(text: string): SaidInfo | null {
  const [, to, act] = /^(\S+), (cfp|propose|accept-proposal)\b/.exec(text) ?? [];
  return to && act
    ? { to, topic: `agent/${to}`, conversation: 'hunt#1', protocol: 'fipa-contract-net', act }
    : null;
}

/** Folded, as they are read: newest first. */
function folded(told: [time: number, kind: string, subject: string, text: string][], most = 100): string[] {
  const all = told.map(([time, kind, subject, text], i) => {
    return { sequence: i + 1, time, kind, subject, text, said: saidIn(text) };
  });
  return foldEvents(all, most).map((line) => `${line.event.subject} ×${line.times} ${words(line)}`);
}

it('what is seen again and again is one line with the newest', () =>
  expect(
    folded([
      [1, 'message', 'escape-1', 'I see hunter-1 at (9.00, -1.57, -162°)'],
      [1, 'message', 'escape-1', 'I see hunter-2 at (2.00, -1.5, 10°)'],
      [1.2, 'agent', 'hunt', 'hunting prey-1'],
      [1.5, 'message', 'escape-1', 'I see hunter-1 at (8.00, -1.57, -162°)'],
      [1.5, 'message', 'escape-2', 'I see hunter-1 at (8.00, -1.57, -162°)'],
    ]),
  ).toEqual([
    'escape-2 ×1 I see hunter-1 at (8.00, -1.57, -162°)',
    'escape-1 ×3 I see hunter-1 at (8.00, -1.57, -162°)',
    'hunt ×1 hunting prey-1',
  ]));

it('calls for bids to several agents are one line, and again after half a minute', () => {
  const call = (time: number): [number, string, string, string][] => [
    [time, 'message', 'hunt', 'follow-1, cfp: hunt prey-1'],
    [time, 'message', 'hunt', 'follow-2, cfp: hunt prey-1'],
    [time, 'message', 'follow-1', 'hunt, propose: 16.5'],
    [time, 'message', 'hunt', 'follow-1, accept-proposal: hunt prey-1'],
  ];
  expect(folded([...call(1), ...call(5), ...call(31)])).toEqual([
    'hunt ×1 follow-1, accept-proposal: hunt prey-1',
    'follow-1 ×1 hunt, propose: 16.5',
    'hunt ×2 asks 2 agents for bids: hunt prey-1',
    'hunt ×2 accept-proposal to follow-1: hunt prey-1',
    'follow-1 ×2 propose to hunt: 16.5',
    'hunt ×4 asks 2 agents for bids: hunt prey-1',
  ]);
});

it('where words differ, those of the newest are shown as such', () =>
  expect(
    folded([
      [1, 'message', 'patrol', 'guard-1, accept-proposal: visit (8.3, 5.9)'],
      [1, 'message', 'patrol', 'guard-2, accept-proposal: visit (-10.6, 1.6)'],
    ]),
  ).toEqual(['patrol ×2 accept-proposal to 2 agents, last: visit (-10.6, 1.6)']));

it('what is not a message is never folded', () =>
  expect(
    folded([
      [1, 'collision', 'prey-1', 'ran into wall'],
      [1, 'collision', 'prey-1', 'ran into wall'],
    ]),
  ).toHaveLength(2));

it('only the newest lines are there', () => {
  const many = Array.from({ length: 1000 }, (_, i): [number, string, string, string] => [
    i,
    i % 2 ? 'agent' : 'message',
    'a',
    'word',
  ]);
  const lines = folded(many, 10);
  expect(lines).toHaveLength(10);
  expect(lines[0]).toBe('a ×1 word');
});
