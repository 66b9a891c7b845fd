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
    follow(context, path);
    context.strokeStyle = info.robots[i]!.color;
    context.stroke();
  });
  context.setLineDash([]);
};

/** A line through places, x and y [mm] of one after the other. */
function follow(context: CanvasRenderingContext2D, places: Int32Array) {
  context.beginPath();
  for (let at = 0; at < places.length; at += 2) {
    context.lineTo(places[at]! / 1000, places[at + 1]! / 1000);
  }
}

/** Where robots go next: the way that their local planners mean to go, else where their present motion takes them. */
export const drawMotion: Layer = (context, { info, frame, view, selected }) => {
  context.lineJoin = 'round';
  context.lineWidth = 3 / view.scale;
  context.globalAlpha = 0.7;
  frame.robots.forEach(({ pose, localPath, speed, sideways, turnRate }, i) => {
    if (pose === null || (frame.robots.length > MANY && i !== selected)) {
      return;
    }
    if (localPath !== null) {
      follow(context, localPath);
    } else if (Math.hypot(speed, sideways) < STANDING) {
      return;
    } else {
      context.beginPath();
      for (const { x, y } of motionOf(pose, speed, turnRate, sideways)) {
        context.lineTo(x, y);
      }
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
