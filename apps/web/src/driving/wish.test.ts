import { describe, expect, it } from 'vitest';
import type { Abilities } from '../api/messages';
import { REST, steers, velocityOf, wishAt, wishOf } from './wish';

const can: Abilities = {
  forward: 0.8,
  backward: 0.4,
  sideways: 0,
  turn: 2,
  behaviors: [],
  noBehavior: '',
  noGoal: '',
};

describe('keys', () => {
  it('steer by letters and by arrows alike', () => {
    expect(wishOf(['KeyW'])).toEqual({ ahead: 1, aside: 0, turn: 0 });
    expect(wishOf(['ArrowUp', 'ArrowLeft'])).toEqual(wishOf(['KeyA', 'KeyW']));
    expect(wishOf(['KeyS', 'KeyD', 'KeyQ'])).toEqual({ ahead: -1, aside: 1, turn: -1 });
  });

  it('that want opposite things cancel each other, and twice is not faster', () => {
    expect(wishOf(['KeyW', 'ArrowDown'])).toEqual(REST);
    expect(wishOf(['KeyW', 'ArrowUp']).ahead).toBe(1);
    expect(wishOf([])).toEqual(REST);
  });

  it('without a meaning do not steer', () => {
    expect(steers('KeyE')).toBe(true);
    for (const code of ['KeyP', 'Space', 'ShiftLeft', 'F8']) {
      expect(steers(code)).toBe(false);
      expect(wishOf([code])).toEqual(REST);
    }
  });
});

describe('the pad', () => {
  it('goes ahead upwards and turns to where the finger is', () => {
    expect(wishAt(0, -1)).toEqual({ ahead: 1, aside: 0, turn: 0 });
    expect(wishAt(0.52, 0.31)).toEqual({ ahead: -0.3, aside: 0, turn: -0.5 });
  });

  it('ends at its edge', () => {
    expect(wishAt(-7, 5)).toEqual({ ahead: -1, aside: 0, turn: 1 });
    expect(wishAt(0.01, 0.01)).toEqual(REST);
  });
});

describe('a velocity', () => {
  it('is a share of what the robot can', () => {
    expect(velocityOf({ ahead: 1, aside: 0, turn: 0.5 }, can, 0.5)).toEqual({ vx: 0.4, vy: 0, omega: 0.5 });
    expect(velocityOf({ ahead: -1, aside: 1, turn: 0 }, can, 1)).toEqual({ vx: -0.4, vy: 0, omega: 0 });
    expect(velocityOf({ ahead: 0, aside: -1, turn: 0 }, { ...can, sideways: 0.6 }, 1).vy).toBe(-0.6);
  });
});
