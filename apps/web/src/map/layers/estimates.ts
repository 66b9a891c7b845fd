import type { Estimate, Hypothesis, Pose } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';
import { size } from './robots';

/** Radius in deviations that holds 95 % of a two-dimensional normal distribution: √(−2 ln 0.05). */
const DEVIATIONS = 2.45;

/** A robot that is drawn smaller than this [px] would be hidden by an outline. */
const LEAST_PIXELS = 10;

/** The least likely place is drawn so strongly: it must be seen by a projector's light, too. */
const FAINTEST = 0.5;

/**
 * Where localizers believe robots to be: outline, and the ellipse they are in with 95 % certainty. Where else they hold
 * possible that they are: the same, the fainter the less likely it is, and without the fill.
 */
export const drawEstimates: Layer = (context, { info, frame, view, palette }) => {
  frame.robots.forEach(({ estimate, elsewhere }, i) => {
    if (estimate === null) {
      return;
    }
    const { color, footprint } = info.robots[i]!;
    if (size(footprint) * view.scale > LEAST_PIXELS) {
      drawOutline(context, estimate.pose, footprint, palette.text, view.scale);
    }
    drawEllipse(context, estimate, color, view.scale, 1);
    for (const other of elsewhere) {
      const strength = Math.max(FAINTEST, other.weight);
      context.save();
      context.globalAlpha = strength;
      drawOutline(context, other.pose, footprint, color, view.scale);
      context.restore();
      drawEllipse(context, other, color, view.scale, strength);
    }
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

/** @param strength 1 for the most likely place */
function drawEllipse(
  context: CanvasRenderingContext2D,
  estimate: Estimate | Hypothesis,
  color: string,
  scale: number,
  strength: number,
) {
  const { major, minor, angle } = ellipse(estimate);
  context.beginPath();
  context.ellipse(estimate.pose.x, estimate.pose.y, major, minor, angle, 0, 2 * Math.PI);
  if (strength === 1) {
    context.globalAlpha = 0.12;
    context.fillStyle = color;
    context.fill();
  }
  context.globalAlpha = strength === 1 ? 0.7 : strength;
  context.strokeStyle = color;
  context.lineWidth = (strength === 1 ? 1.5 : 2) / scale;
  context.stroke();
  context.globalAlpha = 1;
}

/** Half axes [m] and direction [rad] of the ellipse of 95 % certainty. */
export function ellipse({ xx, xy, yy }: Estimate | Hypothesis): {
  major: number;
  minor: number;
  angle: number;
} {
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  return {
    major: DEVIATIONS * Math.sqrt(Math.max(0, mean + spread)),
    minor: DEVIATIONS * Math.sqrt(Math.max(0, mean - spread)),
    angle: Math.atan2(2 * xy, xx - yy) / 2,
  };
}
