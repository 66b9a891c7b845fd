import { describe, expect, it } from 'vitest';
import type { LinkInfo } from '../../api/messages';
import { linesOf } from './links';

const places: Record<string, { x: number; y: number }> = { ann: { x: 0, y: 0 }, bob: { x: 10, y: 0 } };

const lines = (link: Partial<LinkInfo>) =>
  linesOf(
    [
      {
        one: 'ann',
        other: 'bob',
        there: false,
        back: false,
        saidThere: false,
        saidBack: false,
        ...link,
      },
    ],
    (robot) => places[robot] ?? null,
    () => 0.5,
    0.01,
  );

describe('links', () => {
  it('have no heads where both hear each other', () => {
    const { open, used } = lines({ there: true, back: true });
    expect(open).toEqual([{ from: places.ann, to: places.bob, heads: [] }]);
    expect(used).toEqual([]);
  });

  it('point at the one who hears where the other does not', () => {
    const [there] = lines({ there: true }).open;
    expect(there!.heads).toHaveLength(1);
    expect(there!.heads[0]!.tip.x).toBeCloseTo(10 - 0.53);
    expect(there!.heads[0]!.x).toBe(1);
    const [back] = lines({ back: true }).open;
    expect(back!.heads[0]!.tip.x).toBeCloseTo(0.53);
    expect(back!.heads[0]!.x).toBe(-1);
  });

  it('point at each who just heard something, even if no more is heard now', () => {
    expect(lines({ saidThere: true, saidBack: true }).used[0]!.heads).toHaveLength(2);
    const { open, used } = lines({ saidBack: true });
    expect(open).toEqual([]);
    expect(used[0]!.heads[0]!.tip.x).toBeCloseTo(0.53);
  });

  it('of robots that are nowhere, or at one place, are none', () => {
    expect(lines({ other: 'zoe', there: true }).open).toEqual([]);
    expect(lines({ other: 'ann', there: true }).open).toEqual([]);
  });
});
