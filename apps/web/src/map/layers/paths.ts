import type { Pose } from '../../live/frame';
import type { Layer } from '../scene';

/** How far ahead motion is drawn [s]. */
const AHEAD = 2;
const STEPS = 12;
/** Slower than this a robot stands [m/s]. */
const STANDING = 0.02;
/** Of more robots, only the selected one's motion is drawn: it would be lost in the others'. */
const MANY = 60;

/** Planned ways, dashed. */
export const drawPaths: Layer = (context, { info, frame, view }) => {
  context.lineWidth = 2 / view.scale;
  context.lineJoin = 'round';
  context.setLineDash([7 / view.scale, 5 / view.scale]);
  frame.robots.forEach(({ path }, i) => {
    if (path === null) {
      return;
    }
    context.beginPath();
    for (let at = 0; at < path.length; at += 2) {
      context.lineTo(path[at]! / 1000, path[at + 1]! / 1000);
    }
    context.strokeStyle = info.robots[i]!.color;
    context.stroke();
  });
  context.setLineDash([]);
};

/** Where their present motion takes robots next. */
export const drawMotion: Layer = (context, { info, frame, view, selected }) => {
  context.lineJoin = 'round';
  context.lineWidth = 3 / view.scale;
  context.globalAlpha = 0.7;
  frame.robots.forEach(({ pose, speed, sideways, turnRate }, i) => {
    if (
      pose === null ||
      Math.hypot(speed, sideways) < STANDING ||
      (frame.robots.length > MANY && i !== selected)
    ) {
      return;
    }
    context.beginPath();
    for (const { x, y } of motionOf(pose, speed, turnRate, sideways)) {
      context.lineTo(x, y);
    }
    context.strokeStyle = info.robots[i]!.color;
    context.stroke();
  });
  context.globalAlpha = 1;
};

/**
 * Places on the arc that a robot drives when it goes on as it does.
 *
 * @param speed ahead [m/s]
 * @param turnRate counter-clockwise [rad/s]
 * @param sideways to the left [m/s]
 */
export function motionOf(
  { x, y, heading }: Pose,
  speed: number,
  turnRate: number,
  sideways = 0,
): { x: number; y: number }[] {
  const way = Math.hypot(speed, sideways);
  const direction = heading + Math.atan2(sideways, speed);
  return Array.from({ length: STEPS + 1 }, (_, step) => {
    const turn = (turnRate * AHEAD * step) / STEPS;
    const length = (way * AHEAD * step) / STEPS;
    const chord = turn === 0 ? length : (2 * length * Math.sin(turn / 2)) / turn;
    return { x: x + chord * Math.cos(direction + turn / 2), y: y + chord * Math.sin(direction + turn / 2) };
  });
}
