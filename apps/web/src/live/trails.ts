import type { Trails as Told } from '../api/messages';
import type { Frame } from './frame';

/** How long a trail is [simulated s], and how far apart its points [m]. */
const SECONDS = 30;
export const SPACING = 0.05;
/** Who got farther than this between two frames [m], and faster than a robot drives [m/s], was put there. */
const JUMP = 1;
const FASTEST = 3;
/** What has been is known more closely than frames that are farther apart tell, as when it is played fast [s]. */
const LONGEST_GAP = 1;

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
  private newest: Frame | null = null;

  /** Whether somebody looks at another time than that which follows the frame before. */
  private isElsewhere({ run, past, looks, time }: Frame): boolean {
    const { newest } = this;
    return (
      newest === null ||
      run !== newest.run ||
      past !== newest.past ||
      looks !== newest.looks ||
      time < newest.time
    );
  }

  /** @returns whether the server knows better where they have been, so that it is to be asked */
  add(frame: Frame): boolean {
    const elsewhere = this.isElsewhere(frame);
    const gap = elsewhere ? 0 : frame.time - this.newest!.time;
    const unknown = frame.past && gap > LONGEST_GAP;
    if (elsewhere) {
      this.trails = [];
    }
    while (this.trails.length < frame.robots.length) {
      this.trails.push({ x: [], y: [], time: [], driven: [] });
    }
    const farthest = unknown ? 0 : Math.max(JUMP, FASTEST * gap);
    this.newest = frame;
    frame.robots.forEach(({ pose }, i) => {
      const trail = this.trails[i]!;
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
      forget(trail, frame.time - SECONDS);
    });
    return elsewhere || unknown;
  }

  /**
   * Where robots went before a frame that was added, as the server knows it.
   *
   * @param frame of which it was asked; nothing happens when somebody looks elsewhere by now
   */
  learn(told: Told, frame: Frame) {
    const now = this.newest;
    if (now === null || now.run !== frame.run || now.past !== frame.past || now.looks !== frame.looks) {
      return;
    }
    told.robots.forEach(({ times, xs, ys, driven }, i) => {
      const trail = this.trails[i];
      if (!trail) {
        return;
      }
      const last = times.at(-1) ?? -Infinity;
      const later = trail.time.findIndex((time) => time > last);
      const from = later < 0 ? trail.time.length : later;
      const goesOn =
        from < trail.time.length &&
        times.length > 0 &&
        Math.hypot(trail.x[from]! - xs.at(-1)!, trail.y[from]! - ys.at(-1)!) <=
          Math.max(JUMP, FASTEST * Math.min(LONGEST_GAP, trail.time[from]! - last));
      trail.x = xs.concat(trail.x.slice(from));
      trail.y = ys.concat(trail.y.slice(from));
      trail.driven = driven.concat(trail.driven.slice(from));
      trail.time = times.concat(trail.time.slice(from));
      if (goesOn) {
        trail.driven[times.length] = true;
      }
      forget(trail, now.time - SECONDS);
    });
  }

  of(robot: number): Readonly<Trail> | undefined {
    return this.trails[robot];
  }
}

/** What is older. */
function forget(trail: Trail, least: number) {
  const old = trail.time.findIndex((time) => time >= least);
  const gone = old < 0 ? trail.time.length : old;
  if (gone > 0) {
    trail.x.splice(0, gone);
    trail.y.splice(0, gone);
    trail.time.splice(0, gone);
    trail.driven.splice(0, gone);
  }
}
