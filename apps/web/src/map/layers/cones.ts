import { BROKEN, NOTHING, TOO_CLOSE } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';

/** Sonar cones: as far as the nearest echo, with an arc where it came from. */
export const drawCones: Layer = (context, { info, frame, view }) => {
  frame.robots.forEach(({ pose, cones }, i) => {
    if (pose === null || cones === null) {
      return;
    }
    const { fieldOfView, rangeMax, unit } = cones;
    context.save();
    enter(context, pose);
    context.strokeStyle = info.robots[i]!.color;
    context.fillStyle = info.robots[i]!.color;
    context.lineWidth = 1.5 / view.scale;
    for (const { baseFromSensor, range } of cones.sensors) {
      if (range === TOO_CLOSE || range === BROKEN) {
        continue;
      }
      const length = range === NOTHING ? rangeMax : range * unit;
      context.save();
      enter(context, baseFromSensor);
      context.beginPath();
      context.moveTo(0, 0);
      context.arc(0, 0, length, -fieldOfView / 2, fieldOfView / 2);
      context.closePath();
      context.globalAlpha = 0.07;
      context.fill();
      if (range !== NOTHING) {
        context.beginPath();
        context.arc(0, 0, length, -fieldOfView / 2, fieldOfView / 2);
        context.globalAlpha = 0.6;
        context.stroke();
      }
      context.restore();
    }
    context.restore();
  });
};
