import { expect, it } from 'vitest';
import type { EventInfo, SaidInfo } from '../api/messages';
import { ANY, choiceOf, CONVERSATIONS, hasConversations, sequenceOf, withRoutine } from './sequence';

let sequence = 0;

function event(subject: string, said: SaidInfo | null, text = ''): EventInfo {
  sequence++;
  return { sequence, time: sequence, kind: 'message', subject, text, said };
}

function act(to: string, name: string, conversation = 'hunt#1'): SaidInfo {
  return { to, topic: `agent/${to}`, conversation, protocol: 'fipa-contract-net', act: name };
}

const toAll: SaidInfo = { to: '', topic: 'prey', conversation: '', protocol: '', act: '' };

const events = [
  event('escape-1', toAll, 'prey-1 is at (1, 2)'),
  event('hunt', null, 'hunting prey-1'),
  event('hunt', act('follow-1', 'cfp')),
  event('hunt', act('follow-2', 'cfp')),
  event('follow-2', act('hunt', 'refuse')),
  event('follow-1', act('hunt', 'inform', 'other#1')),
];

const words = (wanted = ANY, most = 100) => {
  const { agents, arrows } = sequenceOf(events, wanted, most);
  return arrows.map(
    ({ from, to, label, refuses }) =>
      `${agents[from]} → ${to === null ? 'all' : agents[to]}: ${label}${refuses ? '!' : ''}`,
  );
};

it('what is said all the time is among what happened, by its time', () => {
  const said = { ...toAll, topic: 'pose' };
  const pose = (time: number) => ({ time, from: 'follow-1', text: `at ${time}`, said });
  const all = withRoutine(events, [pose(1.5), pose(99)]);
  expect(all).toHaveLength(events.length + 2);
  expect(all.map(({ text }) => text)).toEqual(
    expect.arrayContaining(['at 1.5', 'at 99', 'prey-1 is at (1, 2)']),
  );
  expect(all[1]!.text).toBe('at 1.5');
  expect(all.at(-1)!.text).toBe('at 99');
  expect(new Set(all.map(({ sequence }) => sequence)).size).toBe(all.length);
  expect(withRoutine(events, [])).toBe(events);
});

it('each that was said is an arrow, oldest first', () =>
  expect(words()).toEqual([
    'escape-1 → all: prey-1 is at (1, 2)',
    'hunt → follow-1: cfp',
    'hunt → follow-2: cfp',
    'follow-2 → hunt: refuse!',
    'follow-1 → hunt: inform',
  ]));

it('what is no act of a conversation is shown in its words, with as many digits as people read', () => {
  const speech: SaidInfo = { ...toAll, to: 'collect-1', topic: 'speech' };
  const told = event('fetch', speech, 'achieve: call(3, -4.718629821801143, 2)');
  expect(sequenceOf([told], ANY, 100).arrows[0]!.label).toBe('achieve: call(3, -4.719, 2)');
});

it('what one says to all again and again is there once, until a topic is chosen', () => {
  const says = (
    time: number,
    subject: string,
    text: string,
    said: SaidInfo = { ...toAll, topic: 'depot' },
  ) => ({
    ...event(subject, said, text),
    time,
  });
  const all = [
    says(0, 'collect-1', 'here'),
    says(0, 'collect-2', 'there'),
    says(10, 'collect-1', 'here'),
    says(20, 'collect-1', 'elsewhere'),
    says(40, 'collect-1', 'here'),
    says(71, 'collect-1', 'here'),
    says(72, 'collect-1', 'here', act('collect-2', 'inform', '')),
    says(73, 'collect-1', 'here', act('collect-2', 'inform', '')),
  ];
  const { arrows, left } = sequenceOf(all, ANY, 6);
  expect(arrows.map(({ time, words, times }) => `${time}: ${words} ×${times}`)).toEqual([
    '0: here ×3',
    '0: there ×1',
    '20: elsewhere ×1',
    '71: here ×1',
    '72: here ×1',
    '73: here ×1',
  ]);
  expect(left).toBe(0);
  expect(sequenceOf(all, { ...ANY, topic: 'depot' }, 100).arrows).toHaveLength(6);
});

it('what is said to one agent is a conversation, too', () => {
  const speech: SaidInfo = { ...toAll, to: 'collect-1', topic: 'speech' };
  const all = [events[0]!, event('fetch', speech, 'achieve: wait')];
  expect(hasConversations(all)).toBe(true);
  expect(sequenceOf(all, { ...ANY, topic: CONVERSATIONS }, 100).arrows.map(({ label }) => label)).toEqual([
    'achieve: wait',
  ]);
});

it('messages to all make no conversation', () => {
  expect(hasConversations(events)).toBe(true);
  expect(hasConversations(events.slice(0, 2))).toBe(false);
});

it('columns are those who speak or are spoken to in it, in the order of the run', () => {
  expect(sequenceOf(events, ANY, 100).agents).toEqual(['escape-1', 'hunt', 'follow-1', 'follow-2']);
  expect(sequenceOf(events, ANY, 2).agents).toEqual(['hunt', 'follow-1', 'follow-2']);
  expect(sequenceOf(events, ANY, 2).left).toBe(3);
});

it('an agent, a topic, a protocol, and a conversation leave the others out, each and together', () => {
  expect(words({ ...ANY, agent: 'follow-1' })).toEqual(['hunt → follow-1: cfp', 'follow-1 → hunt: inform']);
  expect(words({ ...ANY, topic: 'prey' })).toEqual(['escape-1 → all: prey-1 is at (1, 2)']);
  expect(words({ ...ANY, topic: CONVERSATIONS })).toHaveLength(4);
  const net = { ...ANY, protocol: 'fipa-contract-net' };
  expect(words(net)).toHaveLength(4);
  expect(words({ ...net, topic: 'agent/hunt' })).toEqual([
    'follow-2 → hunt: refuse!',
    'follow-1 → hunt: inform',
  ]);
  expect(words({ ...net, topic: 'agent/hunt', agent: 'follow-1' })).toEqual(['follow-1 → hunt: inform']);
  expect(words({ ...net, topic: CONVERSATIONS, conversation: 'other#1' })).toEqual([
    'follow-1 → hunt: inform',
  ]);
  expect(words({ ...net, topic: 'prey' })).toEqual([]);
});

it('there is to choose what was said', () =>
  expect(choiceOf(events)).toEqual({
    agents: ['escape-1', 'follow-1', 'follow-2', 'hunt'],
    topics: ['agent/follow-1', 'agent/follow-2', 'agent/hunt', 'prey'],
    protocols: ['fipa-contract-net'],
  }));
