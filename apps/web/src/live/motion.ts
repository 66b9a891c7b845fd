import type { Frame, Pose } from './frame';

interface Arrived {
  frame: Frame;
  at: number;
}

/** Longest time that drawing lags behind to be smooth [ms]; slower frames jump. */
const LONGEST_BLEND = 150;
/**
 * Longest simulated time between two frames that is drawn as a way [s]: that of a run of 15 times real time. In a faster
 * one nobody knows where robots went meanwhile, and drawing what is made up takes processors from it.
 */
const LONGEST_LEAP = 0.75;
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
  const share = shareOf(previous, newest, now);
  return goal.map((to, i) => {
    const from = previous.frame.robots[i]?.pose ?? null;
    return to === null || from === null ? to : between(from, to, share);
  });
}

/** Whether what {@link blend} gives still changes. */
export function isBlending(previous: Arrived | null, newest: Arrived, now: number): boolean {
  return shareOf(previous, newest, now) < 1;
}

/** How much of the way from the frame before to the newest one is to be drawn. */
export function shareOf(previous: Arrived | null, newest: Arrived, now: number): number {
  if (previous === null || Math.abs(newest.frame.time - previous.frame.time) > LONGEST_LEAP) {
    return 1;
  }
  const gap = newest.at - previous.at;
  return gap <= 0 || gap > LONGEST_BLEND ? 1 : Math.min(1, (now - newest.at) / gap);
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
