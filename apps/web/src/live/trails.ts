import type { Frame } from './frame';

/** How long a trail is [simulated s], and how far apart its points [m]. */
const SECONDS = 30;
export const SPACING = 0.05;
/** Who got farther than this between two frames [m], and faster than a robot drives [m/s], was put there. */
const JUMP = 1;
const FASTEST = 3;
/** While a moment after the other is played, frames come at least so often [s]. */
const LONGEST_GAP = 0.5;

interface Trail {
  x: number[];
  y: number[];
  time: number[];
  /** Whether the robot drove there from the point before. */
  driven: boolean[];
}

/** Where robots have been of late, one trail a robot. */
export class Trails {
  private trails: Trail[] = [];
  private run = 0;
  private time = 0; // of the frame before
  private past = false; // likewise

  /** Whether somebody looks at another time than that which follows the frame before. */
  private isElsewhere({ past, time, speed }: Frame): boolean {
    const longest = past ? LONGEST_GAP * (1 + speed) : Infinity;
    return past !== this.past || time < this.time || time - this.time > longest;
  }

  add(frame: Frame) {
    if (frame.run !== this.run || this.isElsewhere(frame)) {
      this.run = frame.run;
      this.trails = [];
    }
    while (this.trails.length < frame.robots.length) {
      this.trails.push({ x: [], y: [], time: [], driven: [] });
    }
    const farthest = Math.max(JUMP, FASTEST * (frame.time - this.time));
    this.time = frame.time;
    this.past = frame.past;
    frame.robots.forEach((robot, i) => {
      const trail = this.trails[i]!;
      const { pose } = robot;
      if (pose === null) {
        return;
      }
      const moved = Math.hypot(pose.x - (trail.x.at(-1) ?? Infinity), pose.y - (trail.y.at(-1) ?? Infinity));
      if (moved > SPACING) {
        trail.x.push(pose.x);
        trail.y.push(pose.y);
        trail.time.push(frame.time);
        trail.driven.push(moved <= farthest);
      }
      const old = trail.time.findIndex((time) => time >= frame.time - SECONDS);
      const gone = old < 0 ? trail.time.length : old;
      if (gone > 0) {
        trail.x.splice(0, gone);
        trail.y.splice(0, gone);
        trail.time.splice(0, gone);
        trail.driven.splice(0, gone);
      }
    });
  }

  of(robot: number): Readonly<Trail> | undefined {
    return this.trails[robot];
  }
}
