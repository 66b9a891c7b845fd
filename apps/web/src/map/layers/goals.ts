import type { Pose } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';

/** Where robots want to be: a ring with the heading they are to have. */
export const drawGoals: Layer = (context, { info, frame, view }) => {
  frame.robots.forEach(({ goal }, i) => {
    if (goal !== null) {
      drawGoal(context, goal, info.robots[i]!.color, view.scale);
    }
  });
};

export function drawGoal(context: CanvasRenderingContext2D, goal: Pose, color: string, scale: number) {
  const radius = Math.max(0.18, 7 / scale);
  context.save();
  enter(context, goal);
  context.strokeStyle = color;
  context.fillStyle = color;
  context.lineWidth = 2 / scale;
  context.beginPath();
  context.arc(0, 0, radius, 0, 2 * Math.PI);
  context.moveTo(radius, 0);
  context.lineTo(1.9 * radius, 0);
  context.stroke();
  context.beginPath();
  context.arc(0, 0, 0.3 * radius, 0, 2 * Math.PI);
  context.fill();
  context.restore();
}
