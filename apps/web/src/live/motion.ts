import type { Frame, Pose } from './frame';

interface Arrived {
  frame: Frame;
  at: number;
}

/** Longest time that drawing lags behind to be smooth [ms]; slower frames jump. */
const LONGEST_BLEND = 150;
/** Who moves farther than this between two frames was put there [m]. */
const FARTHEST_BLEND = 1.5;

/**
 * Where robots are drawn between two frames: on the way from the one before to the newest, which they reach when
 * the next one is due.
 *
 * @param now as performance.now()
 */
export function blend(previous: Arrived | null, newest: Arrived, now: number): (Pose | null)[] {
  const goal = newest.frame.robots.map((robot) => robot.pose);
  if (previous?.frame.robots.length !== goal.length) {
    return goal;
  }
  const share = share01(previous.at, newest.at, now);
  return goal.map((to, i) => {
    const from = previous.frame.robots[i]?.pose ?? null;
    return to === null || from === null ? to : between(from, to, share);
  });
}

/** Whether what {@link blend} gives still changes. */
export function isBlending(previous: Arrived | null, newest: Arrived, now: number): boolean {
  return previous !== null && share01(previous.at, newest.at, now) < 1;
}

/** How much of the way from the frame before to the newest one is to be drawn. */
export function shareOf(previous: Arrived | null, newest: Arrived, now: number): number {
  return previous === null ? 1 : share01(previous.at, newest.at, now);
}

function share01(previous: number, newest: number, now: number): number {
  const gap = newest - previous;
  return gap <= 0 || gap > LONGEST_BLEND ? 1 : Math.min(1, (now - newest) / gap);
}

export function between(from: Pose, to: Pose, share: number): Pose {
  if (share >= 1 || Math.hypot(to.x - from.x, to.y - from.y) > FARTHEST_BLEND) {
    return to;
  }
  return {
    x: from.x + share * (to.x - from.x),
    y: from.y + share * (to.y - from.y),
    heading: wrap(from.heading + share * wrap(to.heading - from.heading)),
  };
}

/** The same angle in [-π, π). */
export function wrap(angle: number): number {
  return angle - 2 * Math.PI * Math.floor((angle + Math.PI) / (2 * Math.PI));
}
