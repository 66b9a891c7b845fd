import type { CameraView } from '../../api/messages';
import type { Layer } from '../scene';
import { enter } from './frames';

/** How far a blob is drawn whose distance nobody knows [m]. */
const UNKNOWN_RANGE = 2;
/** Before and behind where it is [m]. */
const THICK = 0.08;

/** What the selected robot's cameras make out: where they look, and patches of color in the directions in which they are. */
export const drawBlobs: Layer = (context, { poses, selected, cameras, view, palette }) => {
  const pose = selected === null ? null : (poses[selected] ?? null);
  if (!pose) {
    return;
  }
  for (const camera of cameras) {
    context.save();
    enter(context, pose);
    enter(context, camera);
    drawSight(context, camera, palette.accent, 1 / view.scale);
    for (const { color, from, to, range } of camera.blobs) {
      const far = range ?? UNKNOWN_RANGE;
      context.fillStyle = color;
      context.beginPath();
      context.moveTo(0, 0);
      context.arc(0, 0, far, from, to);
      context.closePath();
      context.globalAlpha = 0.25;
      context.fill();
      if (range !== null) {
        context.beginPath();
        context.arc(0, 0, far + THICK, from, to);
        context.arc(0, 0, Math.max(0, far - THICK), to, from, true);
        context.closePath();
        context.globalAlpha = 0.9;
        context.fill();
      }
      context.globalAlpha = 1;
    }
    context.restore();
  }
};

/** The edges of what a camera sees, as far as the farthest blob. */
function drawSight(
  context: CanvasRenderingContext2D,
  { fieldOfView, blobs }: CameraView,
  color: string,
  pixel: number,
) {
  const reach = Math.max(UNKNOWN_RANGE, ...blobs.map(({ range }) => range ?? 0));
  context.beginPath();
  for (const side of [-0.5, 0.5]) {
    context.moveTo(0, 0);
    context.lineTo(reach * Math.cos(side * fieldOfView), reach * Math.sin(side * fieldOfView));
  }
  context.strokeStyle = color;
  context.globalAlpha = 0.5;
  context.lineWidth = pixel;
  context.stroke();
  context.globalAlpha = 1;
}
