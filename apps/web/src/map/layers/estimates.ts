import type { Estimate } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';

/** Radius in deviations that holds 95 % of a two-dimensional normal distribution: √(−2 ln 0.05). */
const DEVIATIONS = 2.45;

/** Where localizers believe robots to be: outline, and the ellipse they are in with 95 % certainty. */
export const drawEstimates: Layer = (context, { info, frame, view }) => {
  frame.robots.forEach(({ estimate }, i) => {
    if (estimate === null) {
      return;
    }
    const { color, footprint } = info.robots[i]!;
    context.strokeStyle = color;
    context.lineWidth = 1.5 / view.scale;
    context.save();
    enter(context, estimate.pose);
    context.setLineDash([3 / view.scale, 3 / view.scale]);
    context.beginPath();
    footprint.forEach(([x, y]) => context.lineTo(x!, y!));
    context.closePath();
    context.stroke();
    context.restore();
    drawEllipse(context, estimate, color);
  });
};

function drawEllipse(context: CanvasRenderingContext2D, estimate: Estimate, color: string) {
  const { major, minor, angle } = ellipse(estimate);
  context.beginPath();
  context.ellipse(estimate.pose.x, estimate.pose.y, major, minor, angle, 0, 2 * Math.PI);
  context.globalAlpha = 0.12;
  context.fillStyle = color;
  context.fill();
  context.globalAlpha = 0.7;
  context.stroke();
  context.globalAlpha = 1;
}

/** Half axes [m] and direction [rad] of the ellipse of 95 % certainty. */
export function ellipse({ xx, xy, yy }: Estimate): { major: number; minor: number; angle: number } {
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  return {
    major: DEVIATIONS * Math.sqrt(Math.max(0, mean + spread)),
    minor: DEVIATIONS * Math.sqrt(Math.max(0, mean - spread)),
    angle: Math.atan2(2 * xy, xx - yy) / 2,
  };
}
