import type { Pose } from '../../live/frame';

/** From here on, coordinates are in the frame that has this pose. Between `save` and `restore`. */
export function enter(context: CanvasRenderingContext2D, pose: Pose) {
  context.translate(pose.x, pose.y);
  context.rotate(pose.heading);
}
