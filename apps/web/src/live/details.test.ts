import { expect, it } from 'vitest';
import type { AgentDetails, Details, RobotDetails } from '../api/messages';
import { merged } from './details';

const robot = (id: string, behavior = '') => ({ id, behavior }) as RobotDetails;
const agent = (name: string, state = '') => ({ name, state }) as AgentDetails;
const details = (whole: boolean, robots: RobotDetails[], agents: AgentDetails[]): Details => ({
  run: 1,
  whole,
  ending: null,
  robots,
  agents,
});

it('is sent all at first, and whenever somebody has left', () => {
  const all = details(true, [robot('a'), robot('b')], [agent('x')]);
  expect(merged(null, all)).toBe(all);
  const fewer = details(true, [robot('b')], []);
  expect(merged(all, fewer)).toBe(fewer);
});

it('replaces what has changed, in place, and keeps the rest as it is', () => {
  const all = details(true, [robot('a'), robot('b')], [agent('x'), agent('y')]);
  const now = merged(all, details(false, [robot('b', 'wander')], [agent('x', 'roams'), agent('z')]));
  expect(now).toEqual(
    details(true, [robot('a'), robot('b', 'wander')], [agent('x', 'roams'), agent('y'), agent('z')]),
  );
  expect(now.robots[0]).toBe(all.robots[0]);
  expect(now.agents[1]).toBe(all.agents[1]);
});

it('knows the end', () => {
  const ending = { outcome: 'success' } as Details['ending'];
  const now = merged(details(true, [robot('a')], []), { ...details(false, [], []), ending });
  expect(now.ending).toBe(ending);
  expect(now.robots).toHaveLength(1);
});
