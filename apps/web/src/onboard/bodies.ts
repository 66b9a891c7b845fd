import type { CarriedInfo, RobotInfo } from '../api/messages';
import type { Pose } from '../live/frame';
import { carriedPieces } from '../map/layers/carried';
import { piecesOf } from '../map/layers/robots';
import { uprightsOf, type Standing } from '../map/layers/uprights';
import { channelsOf } from '../shades';
import type { Prism } from './picture';

/** Lower eyes would see little but the floor [m]. */
const LOWEST_EYE = 0.3;
/** How far eyes are above what carries them [m]. */
const ABOVE = 0.05;

/** How high the top of a robot is [m]. */
export function topOf(robot: RobotInfo): number {
  return Math.max(...piecesOf(robot).map(({ high }) => high));
}

/** How high up a robot is looked from: over its own body [m]. */
export function eyeOf(robot: RobotInfo): number {
  return Math.max(LOWEST_EYE, topOf(robot) + ABOVE);
}

/** @param carried what its actuators have carried elsewhere */
export function robotPrisms(
  robot: RobotInfo,
  pose: Pose,
  color: string,
  carried: readonly CarriedInfo[] | undefined,
): Prism[] {
  return prismsOf({ pose, pieces: carriedPieces(piecesOf(robot), carried), height: 0 }, color);
}

/** @param plain color of pieces that have none */
export function prismsOf(thing: Standing, plain: string): Prism[] {
  return uprightsOf(thing).map(({ outline, pieces, top }) => ({
    outline,
    low: thing.height + pieces[0]!.low,
    high: top,
    color: channelsOf(pieces[0]!.color ?? plain),
  }));
}
