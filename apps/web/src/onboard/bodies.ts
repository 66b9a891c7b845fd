import type { PieceInfo, RobotInfo } from '../api/messages';
import type { Pose } from '../live/frame';
import type { Thing } from '../live/things';
import { ROBOT_HEIGHT } from '../map/layers/heights';
import { uprightsOf } from '../map/layers/uprights';
import type { Prism, Rgb } from './picture';

/** Lower eyes would see little but the floor [m]. */
const LOWEST_EYE = 0.3;
/** How far eyes are above what carries them [m]. */
const ABOVE = 0.05;

/** Of a robot, in its own frame; its footprint when nothing else is told. */
function piecesOf({ pieces, footprint }: RobotInfo): PieceInfo[] {
  return pieces.length > 0
    ? pieces
    : [{ color: null, corners: footprint, radius: 0, low: 0, high: ROBOT_HEIGHT }];
}

/** How high the top of a robot is [m]. */
export function topOf(robot: RobotInfo): number {
  return Math.max(...piecesOf(robot).map(({ high }) => high));
}

/** How high up a robot is looked from: over its own body [m]. */
export function eyeOf(robot: RobotInfo): number {
  return Math.max(LOWEST_EYE, topOf(robot) + ABOVE);
}

export function robotPrisms(robot: RobotInfo, pose: Pose, color: string): Prism[] {
  return prismsOf({ pose, pieces: piecesOf(robot), height: 0 }, color);
}

/** @param plain color of pieces that have none */
export function prismsOf(thing: Pick<Thing, 'pose' | 'pieces' | 'height'>, plain: string): Prism[] {
  return uprightsOf(thing).map(({ outline, pieces, top }) => ({
    outline,
    low: thing.height + pieces[0]!.low,
    high: top,
    color: rgbOf(pieces[0]!.color ?? plain),
  }));
}

const known = new Map<string, Rgb>();

/** @param color `#rrggbb` */
export function rgbOf(color: string): Rgb {
  let rgb = known.get(color);
  if (!rgb) {
    const [red, green, blue] = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
    rgb = [red!, green!, blue!];
    known.set(color, rgb);
  }
  return rgb;
}
