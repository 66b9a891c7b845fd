import { expect, it } from 'vitest';
import type { ChangeInfo } from '../api/messages';
import { foldHistory } from './history';

const change = (time: number, kind: ChangeInfo['kind'], name: string, words = 'x'): ChangeInfo => ({
  time,
  kind,
  name,
  words,
});

it('what always changes is shown once, at the place of the newest', () => {
  const poses = [1, 2, 3, 4, 6].map((time) => change(time, 'BELIEVES', 'pose'));
  const changes = [...poses, change(5, 'WANTS', 'guard'), change(5, 'DOES', '')].sort(
    (a, b) => a.time - b.time,
  );
  expect(foldHistory(changes).map(({ change: { time, name }, times }) => [time, name, times])).toEqual([
    [6, 'pose', 5],
    [5, '', 1],
    [5, 'guard', 1],
  ]);
});

it('what it does, and what changes now and then, is shown each time', () => {
  const changes = [1, 2, 3, 4, 5, 6].flatMap((time) => [
    change(time, 'DOES', ''),
    ...(time < 5 ? [change(time, 'BELIEVES', 'near')] : []),
  ]);
  expect(foldHistory(changes)).toHaveLength(10);
  expect(foldHistory(changes).every(({ times }) => times === 1)).toBe(true);
});
