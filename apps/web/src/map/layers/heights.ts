import type { MapInfo } from '../../api/messages';

/** Of robots that are told by their footprint alone; what bodies have that say nothing else [m]. */
export const ROBOT_HEIGHT = 0.25;

/** Of walls whose world says no heights: lower than most, so that rooms are seen [m]. */
const WALL_HEIGHT = 1;

/** What is no higher hides nothing that stands on it or behind it [m]. */
export const FLAT = 0.1;

/** How high the walls of a map are drawn [m]. */
export function wallHeight(map: MapInfo): number {
  return map.wallHeight ?? WALL_HEIGHT;
}
