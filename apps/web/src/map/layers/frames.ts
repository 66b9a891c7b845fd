import type { Pose } from '../../live/frame';
import type { Context } from '../context';

/** From here on, coordinates are in the frame that has this pose. Between `save` and `restore`. */
export function enter(context: Context, pose: Pose) {
  context.translate(pose.x, pose.y);
  context.rotate(pose.heading);
}

/** A pose in a frame that has a pose itself. */
export function compose(frame: Pose, { x, y, heading }: Pose): Pose {
  const [cos, sin] = [Math.cos(frame.heading), Math.sin(frame.heading)];
  return {
    x: frame.x + cos * x - sin * y,
    y: frame.y + sin * x + cos * y,
    heading: frame.heading + heading,
  };
}
