import type { Abilities } from '../api/messages';

/** How a hand wants a robot to move, in parts of what the robot can: each from -1 to 1. */
export interface Wish {
  ahead: number;
  /** To the left. */
  aside: number;
  /** Counter-clockwise. */
  turn: number;
}

/** In the robot's own frame: forward and left [m/s], counter-clockwise [rad/s]. */
export interface Velocity {
  vx: number;
  vy: number;
  omega: number;
}

export const REST: Wish = { ahead: 0, aside: 0, turn: 0 };

/** By where keys are, not by what is printed on them. */
const wishes: Record<string, Partial<Wish>> = {
  KeyW: { ahead: 1 },
  ArrowUp: { ahead: 1 },
  KeyS: { ahead: -1 },
  ArrowDown: { ahead: -1 },
  KeyA: { turn: 1 },
  ArrowLeft: { turn: 1 },
  KeyD: { turn: -1 },
  ArrowRight: { turn: -1 },
  KeyQ: { aside: 1 },
  KeyE: { aside: -1 },
};

export function steers(code: string): boolean {
  return code in wishes;
}

/** Keys that want opposite things cancel each other. */
export function wishOf(codes: Iterable<string>): Wish {
  const sum = { ...REST };
  for (const code of codes) {
    const { ahead = 0, aside = 0, turn = 0 } = wishes[code] ?? {};
    sum.ahead += ahead;
    sum.aside += aside;
    sum.turn += turn;
  }
  return { ahead: unit(sum.ahead), aside: unit(sum.aside), turn: unit(sum.turn) };
}

/**
 * Where on the pad a finger is: up is ahead, left turns left. In tenths, so that not every tremor is an event.
 *
 * @param x from the middle to the right, in radii
 * @param y downwards
 */
export function wishAt(x: number, y: number): Wish {
  return { ahead: tenths(-y), aside: 0, turn: tenths(-x) };
}

/** @param share of the robot's full speed, from 0 to 1 */
export function velocityOf({ ahead, aside, turn }: Wish, can: Abilities, share: number): Velocity {
  return {
    vx: share * ahead * (ahead > 0 ? can.forward : can.backward),
    vy: share * aside * can.sideways,
    omega: share * turn * can.turn,
  };
}

function unit(value: number): number {
  return Math.max(-1, Math.min(1, value));
}

function tenths(value: number): number {
  return Math.round(10 * unit(value)) / 10 + 0; // no negative zero
}
