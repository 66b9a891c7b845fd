/** Heights that nobody tells the page, and an oblique view needs [m]. */

/** Of walls of floor plans: the server tells cells, and not how high they are. Lower than most, so that rooms are seen. */
export const WALL_HEIGHT = 1;

/** Of robots that are told by their footprint alone; what bodies have that say nothing else. */
export const ROBOT_HEIGHT = 0.25;
