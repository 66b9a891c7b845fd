import { BROKEN, NOTHING, TOO_CLOSE } from '../../live/frame';
import type { Layer } from '../scene';
import { enter } from './frames';

/** So many scans upon each other leave the map under them to be seen. */
const CLEAR = 5;

/** How strongly each of many scans is drawn: together they hide no more of the map than a few do. */
export function strengthOf(scans: number): number {
  return Math.min(1, CLEAR / scans);
}

/** Laser scans: what was seen to be free as a light fan, what was hit as dots. Drawn from where they were taken. */
export const drawScans: Layer = (context, { info, frame, view, selected }) => {
  const scans = frame.robots.filter(({ scan }) => scan !== null).length;
  const dot = Math.max(2, Math.min(4, 0.05 * view.scale)) / view.scale;
  frame.robots.forEach(({ pose, scan }, i) => {
    if (pose === null || scan === null) {
      return;
    }
    context.save();
    enter(context, pose);
    enter(context, scan.baseFromLaser);
    const fan = new Path2D();
    const hits = new Path2D();
    fan.moveTo(0, 0);
    for (let beam = 0; beam < scan.ranges.length; beam++) {
      const value = scan.ranges[beam]!;
      if (value === TOO_CLOSE || value === BROKEN) {
        continue;
      }
      const range = value === NOTHING ? scan.rangeMax : value * scan.unit;
      const angle = scan.angleMin + beam * scan.angleIncrement;
      const x = range * Math.cos(angle);
      const y = range * Math.sin(angle);
      fan.lineTo(x, y);
      if (value !== NOTHING) {
        hits.rect(x - dot / 2, y - dot / 2, dot, dot);
      }
    }
    context.fillStyle = info.robots[i]!.color;
    const strength = i === selected ? 1 : strengthOf(scans);
    context.globalAlpha = 0.09 * strength;
    context.fill(fan);
    context.globalAlpha = 0.85 * Math.sqrt(strength);
    context.fill(hits);
    context.restore();
  });
};
