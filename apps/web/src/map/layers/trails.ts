import type { Layer } from '../scene';

/** A trail fades in so many steps. */
const PIECES = 6;
/** Points nearer than this are left out [px]. */
const FINEST = 1.5;

/** Where robots have been, fading with time; those of one color together, as single ones take long where robots are many. */
export const drawTrails: Layer = (context, { info, trails, poses, view }) => {
  context.lineWidth = 2 / view.scale;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  const near = FINEST / view.scale;
  const colors = new Map<string, number[]>();
  info.robots.forEach(({ color }, i) => (colors.get(color) ?? colors.set(color, []).get(color)!).push(i));
  for (const [color, robots] of colors) {
    context.strokeStyle = color;
    for (let piece = 0; piece < PIECES; piece++) {
      context.beginPath();
      for (const i of robots) {
        const trail = trails.of(i);
        const pose = poses[i];
        if (!trail || !pose || trail.x.length < 2) {
          continue;
        }
        const from = Math.floor((piece * trail.x.length) / PIECES);
        const to = Math.min(trail.x.length - 1, Math.floor(((piece + 1) * trail.x.length) / PIECES));
        let x = trail.x[from]!;
        let y = trail.y[from]!;
        context.moveTo(x, y);
        for (let at = from + 1; at <= to; at++) {
          const [nextX, nextY] = [trail.x[at]!, trail.y[at]!];
          if (!trail.driven[at]) {
            context.moveTo(nextX, nextY);
          } else if (at < to && Math.abs(nextX - x) + Math.abs(nextY - y) < near) {
            continue;
          } else {
            context.lineTo(nextX, nextY);
          }
          x = nextX;
          y = nextY;
        }
        if (piece === PIECES - 1) {
          context.lineTo(pose.x, pose.y);
        }
      }
      context.globalAlpha = 0.08 + (0.4 * piece) / PIECES;
      context.stroke();
    }
  }
  context.globalAlpha = 1;
};
