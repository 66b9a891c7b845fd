import { BROKEN, NOTHING, TOO_CLOSE, type Pose, type Scan } from '../../live/frame';
import type { Layer } from '../scene';
import { bgrOf, Dots } from './dots';
import { compose, enter } from './frames';

/** So many scans upon each other leave the map under them to be seen. */
const CLEAR = 5;
/** Of more scans than this, hits are set as dots, and what was seen to be free would hardly be seen. */
const MANY = 40;
const FREE = 0.09;
const HIT = 0.85;

/** How strongly each of many scans is drawn: together they hide no more of the map than a few do. */
export function strengthOf(scans: number): number {
  return Math.min(1, CLEAR / scans);
}

let dots: Dots | null = null; // made where there is a page

/** Laser scans: what was seen to be free as a light fan, what was hit as dots. Drawn from where they were taken. */
export const drawScans: Layer = (context, { info, frame, view, selected }) => {
  const scans = frame.robots.filter(({ scan }) => scan !== null).length;
  const strength = strengthOf(scans);
  const side = Math.max(2, Math.min(4, 0.05 * view.scale)) / view.scale; // of a dot [m]
  const many = scans > MANY;
  if (many) {
    dots ??= new Dots();
    dots.begin(context, side, HIT * Math.sqrt(strength));
  }
  frame.robots.forEach(({ pose, scan }, i) => {
    if (pose === null || scan === null) {
      return;
    }
    const { color } = info.robots[i]!;
    if (many && i !== selected) {
      setHits(dots!, pose, scan, color);
    } else {
      drawScan(context, pose, scan, color, i === selected ? 1 : strength, side);
    }
  });
  if (many) {
    dots!.draw(context);
  }
};

/** Tells of each beam that measured something where it ended, in the laser's frame. */
export function eachBeam(scan: Scan, tell: (x: number, y: number, hit: boolean) => void) {
  let [cos, sin] = [Math.cos(scan.angleMin), Math.sin(scan.angleMin)];
  const [cosStep, sinStep] = [Math.cos(scan.angleIncrement), Math.sin(scan.angleIncrement)];
  for (const value of scan.ranges) {
    if (value !== TOO_CLOSE && value !== BROKEN) {
      const range = value === NOTHING ? scan.rangeMax : value * scan.unit;
      tell(range * cos, range * sin, value !== NOTHING);
    }
    [cos, sin] = [cos * cosStep - sin * sinStep, sin * cosStep + cos * sinStep]; // to the next beam
  }
}

function drawScan(
  context: CanvasRenderingContext2D,
  pose: Pose,
  scan: Scan,
  color: string,
  strength: number,
  side: number,
) {
  context.save();
  enter(context, pose);
  enter(context, scan.baseFromLaser);
  const fan = new Path2D();
  const hits = new Path2D();
  fan.moveTo(0, 0);
  eachBeam(scan, (x, y, hit) => {
    fan.lineTo(x, y);
    if (hit) {
      hits.rect(x - side / 2, y - side / 2, side, side);
    }
  });
  context.fillStyle = color;
  context.globalAlpha = FREE * strength;
  context.fill(fan);
  context.globalAlpha = HIT * Math.sqrt(strength);
  context.fill(hits);
  context.restore();
}

function setHits(into: Dots, pose: Pose, scan: Scan, color: string) {
  const laser = compose(pose, scan.baseFromLaser);
  const [cos, sin] = [Math.cos(laser.heading), Math.sin(laser.heading)];
  const bgr = bgrOf(color);
  eachBeam(scan, (x, y, hit) => {
    if (hit) {
      into.set(laser.x + cos * x - sin * y, laser.y + sin * x + cos * y, bgr);
    }
  });
}
