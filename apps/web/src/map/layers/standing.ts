import type { Layer } from '../scene';
import { drawerOf, drawMarks, heightOf, radius } from './robots';
import { drawThing, movedThings, top } from './things';

/** What is hidden shines through what hides it. */
const HIDING = 0.7;

/**
 * In an oblique view, what moves: robots, and things that were moved, the farthest first. What stands before them is
 * drawn over them alone, to be seen through, so that no robot is out of sight; not over small ones where they are many,
 * which are drawn larger than they are: it would take most of the time, and be a few pixels.
 */
export const drawStanding: Layer = (context, scene) => {
  const { info, poses, view, palette, uprights } = scene;
  const { up } = view;
  const drawRobot = drawerOf(context, scene);
  const bodies = movedThings(scene).map((thing) => ({
    depth: thing.pose.x * up.x + thing.pose.y * up.y,
    place: thing.pose,
    reach: thing.reach,
    height: top(thing),
    draw: (): boolean => {
      drawThing(context, thing, view, palette);
      return false;
    },
  }));
  info.robots.forEach((robot, i) => {
    const pose = poses[i];
    if (pose) {
      drawMarks(context, scene, i);
      bodies.push({
        depth: pose.x * up.x + pose.y * up.y,
        place: pose,
        reach: radius(robot.footprint, view.scale),
        height: heightOf(robot, view.scale),
        draw: () => drawRobot(i),
      });
    }
  });
  bodies.sort((a, b) => b.depth - a.depth);
  for (const { place, reach, height, draw } of bodies) {
    const isSmall = draw();
    if (uprights && !isSmall) {
      context.globalCompositeOperation = 'source-atop';
      context.globalAlpha = HIDING;
      uprights.drawBefore(context, place, reach, height, view, palette);
      context.globalAlpha = 1;
      context.globalCompositeOperation = 'source-over';
    }
  }
};
