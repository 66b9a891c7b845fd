import type { Estimate, Pose } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';
import { size } from './robots';

/** Radius in deviations that holds 95 % of a two-dimensional normal distribution: √(−2 ln 0.05). */
const DEVIATIONS = 2.45;

/** A robot that is drawn smaller than this [px] would be hidden by an outline. */
const LEAST_PIXELS = 10;

/** Where localizers believe robots to be: outline, and the ellipse they are in with 95 % certainty. */
export const drawEstimates: Layer = (context, { info, frame, view, palette }) => {
  frame.robots.forEach(({ estimate }, i) => {
    if (estimate === null) {
      return;
    }
    const { color, footprint } = info.robots[i]!;
    if (size(footprint) * view.scale > LEAST_PIXELS) {
      drawOutline(context, estimate.pose, footprint, palette.text, view.scale);
    }
    drawEllipse(context, estimate, color, view.scale);
  });
};

function drawOutline(
  context: CanvasRenderingContext2D,
  pose: Pose,
  footprint: number[][],
  color: string,
  scale: number,
) {
  context.save();
  enter(context, pose);
  context.beginPath();
  footprint.forEach(([x, y]) => context.lineTo(x!, y!));
  context.closePath();
  context.setLineDash([3 / scale, 3 / scale]);
  context.strokeStyle = color;
  context.lineWidth = 1.25 / scale;
  context.stroke();
  context.restore();
}

function drawEllipse(context: CanvasRenderingContext2D, estimate: Estimate, color: string, scale: number) {
  const { major, minor, angle } = ellipse(estimate);
  context.beginPath();
  context.ellipse(estimate.pose.x, estimate.pose.y, major, minor, angle, 0, 2 * Math.PI);
  context.globalAlpha = 0.12;
  context.fillStyle = color;
  context.fill();
  context.globalAlpha = 0.7;
  context.strokeStyle = color;
  context.lineWidth = 1.5 / scale;
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
