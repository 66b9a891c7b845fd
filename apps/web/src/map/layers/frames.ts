import type { Pose } from '../../live/frame';
import type { Context } from '../scene';

/** From here on, coordinates are in the frame that has this pose. Between `save` and `restore`. */
export function enter(context: Context, pose: Pose) {
  context.translate(pose.x, pose.y);
  context.rotate(pose.heading);
}
