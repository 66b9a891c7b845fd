import type { Layer } from '../scene';

/** Planned paths. */
export const drawPaths: Layer = (context, { info, frame, view }) => {
  context.lineWidth = 2 / view.scale;
  context.lineJoin = 'round';
  context.setLineDash([7 / view.scale, 5 / view.scale]);
  frame.robots.forEach(({ path }, i) => {
    if (path === null) {
      return;
    }
    context.beginPath();
    for (let at = 0; at < path.length; at += 2) {
      context.lineTo(path[at]! / 1000, path[at + 1]! / 1000);
    }
    context.strokeStyle = info.robots[i]!.color;
    context.stroke();
  });
  context.setLineDash([]);
};
