import type { Layer } from '../scene';

/** Where robots have been, fading with time. */
export const drawTrails: Layer = (context, { info, trails, poses, view }) => {
  context.lineWidth = 2 / view.scale;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  info.robots.forEach((robot, i) => {
    const trail = trails.of(i);
    const pose = poses[i];
    if (!trail || !pose || trail.x.length < 2) {
      return;
    }
    context.strokeStyle = robot.color;
    const pieces = 6;
    for (let piece = 0; piece < pieces; piece++) {
      const from = Math.floor((piece * trail.x.length) / pieces);
      const to = Math.floor(((piece + 1) * trail.x.length) / pieces);
      context.beginPath();
      context.moveTo(trail.x[from]!, trail.y[from]!);
      for (let at = from + 1; at <= Math.min(to, trail.x.length - 1); at++) {
        if (trail.driven[at]) {
          context.lineTo(trail.x[at]!, trail.y[at]!);
        } else {
          context.moveTo(trail.x[at]!, trail.y[at]!);
        }
      }
      if (piece === pieces - 1) {
        context.lineTo(pose.x, pose.y);
      }
      context.globalAlpha = 0.08 + (0.4 * piece) / pieces;
      context.stroke();
    }
  });
  context.globalAlpha = 1;
};
