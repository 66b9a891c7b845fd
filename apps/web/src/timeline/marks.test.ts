import { expect, it } from 'vitest';
import type { EventInfo } from '../api/messages';
import { marksAmong, marksOf, shareOf } from './marks';

function event(time: number, kind: string, text = ''): EventInfo {
  return { sequence: 1, time, kind, subject: '', text, said: null };
}

it('what agents say is not marked', () => {
  const events = [event(1, 'message'), event(2, 'caught'), event(3, 'agent'), event(4, 'fault')];
  expect(marksAmong(events).map(({ kind }) => kind)).toEqual(['caught', 'fault']);
});

it('events far from each other have marks of their own, where they are', () => {
  const marks = marksOf([event(10, 'goal'), event(60, 'caught')], 10, 110, 100);
  expect(marks.map(({ share, kind }) => [share, kind])).toEqual([
    [0, 'goal'],
    [0.5, 'caught'],
  ]);
});

it('events near each other have one mark, of what counts most, with the words of all', () => {
  const [mark, ...others] = marksOf(
    [event(5, 'goal', 'a'), event(5.1, 'fault', 'b'), event(5.2, 'caught', 'c')],
    0,
    100,
    50,
  );
  expect(others).toEqual([]);
  expect(mark).toMatchObject({ kind: 'fault', time: 5.1, share: 0.051, left: 0 });
  expect(mark!.events.map(({ text }) => text)).toEqual(['a', 'b', 'c']);
});

it('of many events in one place some are named, and how many more there are', () => {
  const many = Array.from({ length: 500 }, (_, i) => event(i / 1000, 'collision'));
  const [mark] = marksOf(many, 0, 100, 50);
  expect(mark!.events.length + mark!.left).toBe(500);
  expect(mark!.events.length).toBeLessThan(10);
});

it('there are never more marks than there is room for', () => {
  const many = Array.from({ length: 3000 }, (_, i) => event(i / 10, 'goal'));
  expect(marksOf(many, 0, 300, 80)).toHaveLength(80);
});

it('a run that has just begun has no length', () => {
  expect(shareOf(0, 0, 0)).toBe(0);
  expect(marksOf([event(0, 'run')], 0, 0, 80)).toHaveLength(1);
  expect(shareOf(9, 0, 3)).toBe(1);
});
