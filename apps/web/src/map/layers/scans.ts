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

/** The frame's own middle. */
const ORIGIN: Pose = { x: 0, y: 0, heading: 0 };

/**
 * Tells of each beam that measured something where it ended.
 *
 * @param laser in the frame that ends are told in; left out: they are told in the laser's
 */
export function eachBeam(scan: Scan, tell: (x: number, y: number, hit: boolean) => void, laser = ORIGIN) {
  const first = laser.heading + scan.angleMin;
  const [cosStep, sinStep] = [Math.cos(scan.angleIncrement), Math.sin(scan.angleIncrement)];
  let [cos, sin] = [Math.cos(first), Math.sin(first)];
  const { ranges } = scan;
  for (let beam = 0; beam < ranges.length; beam++) {
    const value = ranges[beam]!;
    if (value !== TOO_CLOSE && value !== BROKEN) {
      const range = value === NOTHING ? scan.rangeMax : value * scan.unit;
      tell(laser.x + range * cos, laser.y + range * sin, value !== NOTHING);
    }
    const next = cos * cosStep - sin * sinStep;
    sin = sin * cosStep + cos * sinStep;
    cos = next;
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
  const bgr = bgrOf(color);
  const set = (x: number, y: number, hit: boolean) => {
    if (hit) {
      into.set(x, y, bgr);
    }
  };
  eachBeam(scan, set, compose(pose, scan.baseFromLaser));
}
